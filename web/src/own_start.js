// The user's own initial condition, computed here in doubles: not rigorous, with the command that makes it so.
import { command, h, labelled } from "./dom.js";
import { plural } from "./numbers.js";
import { mostCollisions, orbitFromStart } from "./orbit.js";
import { Player } from "./player.js";
import { fault, numberFrom } from "./start.js";

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
        this.message = h("output", { class: "readout" });
        this.shown = h("div", {});
        this.inputs = fields.map(([name]) => h("input", { type: "text", name, size: "9", inputmode: "decimal", value: start[name], autocomplete: "off" }));
        const form = h(
            "form",
            { class: "controls", onsubmit: (event) => { event.preventDefault(); this.go(); } },
            fields.map(([, text], i) => labelled(text, this.inputs[i])),
            h("button", { type: "submit" }, "Follow it"),
        );
        this.element = h(
            "section",
            { id: "own" },
            h("h2", {}, "Your own initial condition"),
            h("p", { class: "claim" }, h("strong", { class: "warning" }, "Not rigorous: "), "computed by this page in double precision. The rod has length 1, y is the height of the centre of mass, \u03c6 the rod\u2019s angle in radians: the light mass is at y + \u03b2\u2082 sin \u03c6, the heavy one at y \u2212 \u03b2\u2081 sin \u03c6, \u03b2\u2082 = q/(1 + q), \u03b2\u2081 = 1/(1 + q)."),
            form,
            this.message,
            h("figure", { class: "wide" }, this.player.element),
            this.shown,
        );
        this.go();
    }

    /// Values in the order q, phi, phidot, y, ydot.
    set(values) {
        this.inputs.forEach((input, i) => (input.value = String(values[i])));
        this.go();
        this.element.scrollIntoView();
    }

    go() {
        const start = Object.fromEntries(fields.map(([name], i) => [name, numberFrom(this.inputs[i].value)]));
        const wrong = fault(start);
        this.message.classList.toggle("warning", wrong !== null);
        if (wrong) {
            this.message.textContent = wrong;
            return;
        }
        const orbit = orbitFromStart(start);
        const n = orbit.collisions.length;
        this.player.load(orbit);
        this.message.textContent = orbit.complete ? `In doubles: ${plural(n, "collision")}.` : `Followed for ${mostCollisions.toLocaleString("en")} collisions only.`;
        const words = this.inputs.map((input) => input.value.replace(/\u2212/g, "-").replace(/[\s+]/g, ""));
        const options = fields.slice(1).map(([name], i) => `--${name} ${words[i + 1]}`).join(" ");
        this.shown.replaceChildren(h("p", { class: "note" }, "The same orbit with every number enclosed, and its count proved:"), command(`dumbbell trace ${words[0]} ${options}`));
    }
}
