// What every file's section has: the command that verifies it, what it rests on, its checksum.
import { command, copying, h, labelled, table } from "./dom.js";
import { lemmaRows } from "./lemmas.js";
import { missing, verifier } from "./modules/jobs.js";
import { verified } from "./outcome.js";
import { linkOf } from "./proof_link.js";

/// The file as it was given to dumbbell report, or as it came into the page.
const fileOf = ({ blob, bytes, name }) => blob ?? new File([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], name);

/// The heading of a file's section: what it is about, and whether that is verified.
export function heading(file, text) {
    file.badge = h("span", { class: "badge", "data-outcome": "waiting" }, "not verified here");
    return h("div", { class: "title" }, h("h2", {}, text), file.badge);
}

/// The verification, of another claim, too; and the command that does the same. Of a file that came into the page: how to keep it.
export function verifyBox(file) {
    const lacking = missing();
    const isHere = verifier.isHere && lacking.length === 0 && (file.blob ?? file.bytes) !== "";
    const said = isHere
        ? "This page contains the certificate and the independent verifier, which checks it here, with the claim stated from outside. So does this command, without a browser:"
        : `This page shows what the certificate claims. It has not been verified here${verifier.isHere && lacking.length > 0 ? `, for this browser lacks ${lacking.join(", ")}` : ""}; this command has the independent verifier check it, with the claim stated from outside:`;
    const lastly = [h("p", {}, said), command(`dumbbell verify ${file.verify_options} ${file.verify_file}`)];
    if (!isHere) {
        return h("div", { class: "verify" }, lastly);
    }
    const blob = fileOf(file);
    const check = (options) => verified(blob, options.split(/\s+/).filter(Boolean), file.badge);
    const host = h("div", {}, check(file.verify_options));
    const again = () => {
        host.querySelector("button")?.click(); // stops what is under way
        host.replaceChildren(check(claim.value));
    };
    const claim = h("input", { type: "text", class: "claimed", value: file.verify_options, autocomplete: "off", spellcheck: "false" });
    const form = h("form", { class: "controls", onsubmit: (event) => (event.preventDefault(), again()) }, labelled("Claim", claim), h("button", { type: "submit" }, "Verify"));
    return h("div", { class: "verify" }, host, form, file.blob && keeping(blob), lastly);
}

/// Buttons: the certificate as a file, and as a link if that is short enough.
function keeping(blob) {
    const buttons = h("p", { class: "controls" }, h("a", { href: URL.createObjectURL(blob), download: blob.name }, "Save the certificate"));
    linkOf(blob).then((link) => link && buttons.append(copying("Copy link", link), h("span", { class: "note" }, "A proof as a link: whoever opens it, verifies it.")), () => {});
    return buttons;
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
