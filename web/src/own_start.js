// The user's own initial condition, computed here in doubles: not rigorous, with the command that makes it so.
import { command, h, labelled, output } from "./dom.js";
import { plural } from "./numbers.js";
import { mostCollisions, orbitFromStart } from "./orbit.js";
import { Player } from "./player.js";
import { angleFrom, fault, inLetters, linkTo, numberFrom, startFrom } from "./start.js";

const fields = [
    ["q", "mass ratio q"],
    ["phi", "angle \u03c6"],
    ["phidot", "its velocity \u03c6\u2032"],
    ["y", "height y"],
    ["ydot", "its velocity y\u2032"],
];

export class OwnStart {
    constructor(start) {
        this.player = new Player();
        this.message = output("readout");
        this.figure = h("figure", { class: "wide" }, this.player.element);
        this.shown = h("div", {});
        this.inputs = fields.map(([name]) => h("input", { type: "text", name, size: "9", inputmode: "decimal", value: start[name], autocomplete: "off" }));
        const form = h(
            "form",
            { class: "controls", onsubmit: (event) => { event.preventDefault(); this.go(); }, onpaste: (event) => this.paste(event) },
            fields.map(([, text], i) => labelled(text, this.inputs[i])),
            h("button", { type: "submit" }, "Follow it"),
        );
        this.element = h(
            "section",
            { id: "own" },
            h("h2", {}, "Your own initial condition"),
            h("p", { class: "claim" }, h("strong", { class: "warning" }, "Not rigorous: "), "computed by this page in double precision. The rod has length 1, y is the height of the centre of mass, \u03c6 the rod\u2019s angle in radians: the light mass is at y + \u03b2\u2082 sin \u03c6, the heavy one at y \u2212 \u03b2\u2081 sin \u03c6, \u03b2\u2082 = q/(1 + q), \u03b2\u2081 = 1/(1 + q). A whole command \u201cdumbbell trace \u2026\u201d, like the one that \u201cdumbbell certify\u201d prints, can be pasted into any field."),
            form,
            this.message,
            this.figure,
            this.shown,
        );
        this.go();
    }

    /// What is followed; null if the start is none.
    orbit() {
        return this.figure.hidden ? null : this.player.orbit;
    }

    /// Values in the order q, phi, phidot, y, ydot. Says what was found.
    follow(values) {
        this.inputs.forEach((input, i) => (input.value = String(values[i])));
        this.go();
        return this.message.textContent;
    }

    /// The same of the words {q, phi, phidot, y, ydot}, and shows it.
    set(start) {
        this.follow(fields.map(([name]) => start[name]));
        this.element.scrollIntoView();
    }

    paste(event) {
        const start = startFrom(event.clipboardData.getData("text"));
        if (start) {
            event.preventDefault();
            this.set(start);
        }
    }

    go() {
        const start = Object.fromEntries(fields.map(([name], i) => [name, (name === "phi" ? angleFrom : numberFrom)(this.inputs[i].value)]));
        const unread = fields.findIndex(([name]) => Number.isNaN(start[name]));
        const wrong = unread < 0 ? fault(start) : `${fields[unread][1]}: \u201c${this.inputs[unread].value}\u201d is not a number; write one like 3, \u22120.5, 1/3 or 1e4.`;
        this.inputs.forEach((input, i) => input.setAttribute("aria-invalid", String(i === unread)));
        this.message.classList.toggle("warning", wrong !== null);
        this.figure.hidden = wrong !== null;
        if (wrong) {
            this.player.stop();
            this.shown.replaceChildren();
            this.message.textContent = wrong;
            return;
        }
        const isSwapped = start.q < 1;
        const orbit = orbitFromStart(isSwapped ? { ...start, q: 1 / start.q } : start);
        const n = plural(orbit.collisions.length, "collision");
        this.player.load(orbit);
        const found = orbit.complete
            ? `In doubles: ${n}.`
            : orbit.isCorner
              ? `In doubles: ${n}, then both masses hit the floor at once, and no motion is defined.`
              : orbit.collisions.length < mostCollisions
                ? `In doubles: ${n}, then it turns too fast to be followed while it falls.`
                : `Followed for ${mostCollisions.toLocaleString("en")} collisions only.`;
        this.message.textContent = `${isSwapped ? "Ratios below 1: the masses are swapped, q \u2192 1/q. " : ""}${found}`;
        const words = this.inputs.map((input) => inLetters(input.value));
        const options = fields.slice(1).map(([name], i) => `--${name} ${words[i + 1]}`).join(" ");
        this.shown.replaceChildren(h("p", { class: "note" }, "The same orbit with every number enclosed, and its count proved:"), command(`dumbbell trace ${words[0]} ${options}`), h("p", { class: "note" }, h("a", { href: linkTo(words) }, "A link to this start")));
    }
}
