// What a verification says, for people.
import { h, output } from "./dom.js";
import { lines } from "./modules/module.js";
import { verifier } from "./modules/jobs.js";

const colours = { VERIFIED: "good", REJECTED: "bad" };

const spoken = {
    VERIFIED: "Verified",
    REJECTED: "Rejected: this file does not prove the claim",
    OPEN: "Open: the file is right, and proves no bound for all that is in question",
    UNSUPPORTED: "Not supported: the file is of a kind or a version that this verifier does not know",
    LIMIT: "Given up: this file asks for more than the verifier spends on it",
    UNREADABLE: "Not readable",
};

const seconds = (time) => (time < 0.095 ? "less than 0.1\u00a0s" : `${time < 9.95 ? time.toFixed(1) : Math.round(time)}\u00a0s`);

function progressText(work, read, pieces) {
    const of = pieces > 1 ? `${read.toLocaleString("en")} of ${pieces.toLocaleString("en")} pieces, ` : "";
    return `Verifying: ${of}${Math.floor(work)} s of a processor's work`;
}

function outcome({ answer, failure, time, stopped }) {
    if (stopped) {
        return ["Stopped", null, []];
    }
    const { usage, result, line, sentence } = failure ? {} : JSON.parse(answer);
    if (failure || usage) {
        return [failure ? "Given up" : "The claim cannot be read", "bad", [h("p", {}, failure ? `The verifier came to no answer: ${failure}.` : usage)]];
    }
    const { verdict, sha256 } = result;
    return [
        verdict === "VERIFIED" ? `Verified here, in your browser, in ${seconds(time)}` : `${spoken[verdict]} (in ${seconds(time)})`,
        colours[verdict] ?? "open",
        [
            sentence && h("p", { class: "sentence" }, sentence.trim()),
            h("p", {}, h("code", { class: "hash line" }, line)),
            sha256 && h("p", {}, "SHA-256 of the file's text: ", h("code", { class: "hash" }, sha256)),
        ],
    ];
}

/// An element that verifies the file as soon as those before it are done, and says what came of it; its short form in `badge`.
export function verified(file, words, badge = output("badge")) {
    const state = output("state", "Waiting");
    const stop = h("button", { type: "button", onclick: () => job.stop() }, "Stop");
    const rest = h("div", {});
    const element = h("div", { class: "outcome" }, h("p", { class: "controls" }, state, stop), rest);
    const mark = (text, kind) => {
        badge.textContent = text;
        badge.dataset.outcome = kind;
    };
    mark("being verified here", "waiting");
    const job = verifier.call("verify", [lines(words)], { file, progress: (...at) => (state.textContent = progressText(...at)) });
    job.promise.then((result) => {
        const [text, kind, more] = outcome(result);
        stop.remove();
        state.textContent = text;
        mark(kind === "good" ? "verified here" : `not verified: ${text.replace(/[:(].*/, "").trim().toLowerCase()}`, kind ?? "stopped");
        element.dataset.outcome = kind ?? "stopped";
        rest.replaceChildren(...more.filter(Boolean));
    });
    return element;
}
