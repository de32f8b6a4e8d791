// What a verification says, for people.
import { h, output } from "../dom.js";
import { verification } from "./verification.js";

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

function progressText({ seconds: work, read, pieces }) {
    const of = pieces > 1 ? `${read.toLocaleString("en")} of ${pieces.toLocaleString("en")} pieces, ` : "";
    return `Verifying: ${of}${Math.floor(work)} s of a processor's work`;
}

function outcome({ answer, failure, time, stopped }) {
    if (stopped) {
        return ["Stopped", null, []];
    }
    if (failure || answer.usage) {
        return [failure ? "Given up" : "The claim cannot be read", "bad", [h("p", {}, failure ? `The verifier came to no answer: ${failure}.` : answer.usage)]];
    }
    const { verdict, sha256 } = answer.result;
    return [
        verdict === "VERIFIED" ? `Verified here, in your browser, in ${seconds(time)}` : `${spoken[verdict]} (in ${seconds(time)})`,
        colours[verdict] ?? "open",
        [
            answer.sentence && h("p", { class: "sentence" }, answer.sentence.trim()),
            h("p", {}, h("code", { class: "hash line" }, answer.line)),
            sha256 && h("p", {}, "SHA-256 of the file's text: ", h("code", { class: "hash" }, sha256)),
        ],
    ];
}

/// An element that verifies the file as soon as those before it are done, and says what came of it. `over` is called at the end.
export function verified(file, words, over = () => {}) {
    const state = output("state", "Waiting");
    const stop = h("button", { type: "button", onclick: () => job.stop() }, "Stop");
    const rest = h("div", {});
    const element = h("div", { class: "outcome" }, h("p", { class: "controls" }, state, stop), rest);
    const job = verification(file, words, (at) => (state.textContent = progressText(at)));
    job.promise.then((result) => {
        const [text, kind, more] = outcome(result);
        stop.remove();
        state.textContent = text;
        element.dataset.outcome = kind ?? "stopped";
        rest.replaceChildren(...more.filter(Boolean));
        over(result);
    });
    return element;
}
