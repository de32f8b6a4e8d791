// What every file's section has: the command that verifies it, what it rests on, its checksum.
import { command, h, table } from "./dom.js";
import { lemmaRows } from "./lemmas.js";
import { verified } from "./verifier/outcome.js";
import { hasVerifier } from "./verifier/verification.js";

const verifyCommand = (file) => `dumbbell verify ${file.verify_options} ${file.verify_file}`;

/// The file as it was given to dumbbell report.
const fileOf = ({ bytes, name }) => new File([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], name);

export function verifyBox(file) {
    const isHere = hasVerifier();
    const said = isHere
        ? "This page contains the file and the independent verifier, which checks it here, with the claim stated from outside. So does this command, without a browser:"
        : "This page shows what the file claims. It has not been verified here; this command has the independent verifier check it, with the claim stated from outside:";
    return h("div", { class: "verify" }, isHere && verified(fileOf(file), file.verify_options.split(" ")), h("p", {}, said), command(verifyCommand(file)));
}

/// isOpen: shown at once.
export function foundations(file, isOpen) {
    return h(
        "details",
        { class: "tables", open: isOpen },
        h("summary", {}, "What the claim rests on, and checksums"),
        table("Lemmas", ["lemma", "statement", "proof in"], lemmaRows(file)),
        table("The file", null, [
            ["file", file.name],
            ["written by", file.generator],
            ["claim", file.section ? `${file.claim}, section ${file.section}` : file.claim],
            ["SHA-256 of its text (last line)", h("code", { class: "hash" }, file.sha256)],
        ]),
        h("p", { class: "note" }, "The checksum agrees with the text: the file is not damaged. It proves nothing, as whoever forges a file can compute one."),
    );
}
