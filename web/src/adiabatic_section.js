// A certificate about the adiabatic invariant: its statement and constants, its boxes, and the orbits that attain values close to
// the constants.
import { Cover } from "./cover.js";
import { h, labelled, select, table } from "./dom.js";
import { foundations, heading, verifyBox } from "./file_tables.js";
import { plural, shortened, show } from "./numbers.js";
import { orbitFromContact } from "./orbit.js";
import { Player } from "./player.js";
import { parse, toNumber } from "./rational.js";
import { shade } from "./theme.js";

const range = ([lo, hi]) => (lo === hi ? lo : `from ${lo} to ${hi}`);
const delta = ([lo, hi]) => (lo === hi ? `For \u03b4 = ${lo}` : `For every \u03b4 from ${lo} to ${hi}`);

/// delta to the power n/16, as people write it.
function power(n) {
    let below = 16;
    for (; n % 2 === 0 && below > 1; n /= 2) {
        below /= 2;
    }
    return n === 0 ? "1" : below === 1 ? `\u03b4${n === 1 ? "" : `^${n}`}` : n === 1 && below === 2 ? "\u221a\u03b4" : `\u03b4^(${n}/${below})`;
}

/// Of each claim: its name, its statement, and what its constants are units of.
const statements = {
    "adiabatic-bounce": {
        title: "one bounce",
        of: (f) => `${delta(f.delta)} and every bounce of the light mass at height ${range(f.heights)}, at least ${f.margin}${f.exponent === 0 ? "" : ` ${power(f.exponent)}`} from the vertical, whose next collision is one of the light mass: the errors E1 \u2264 ${f.bounds[0]} ${power(32 - 2 * f.exponent)} and E2 \u2264 2 \u00b7 ${f.bounds[1]} ${power(32 - f.exponent)}.`,
        units: (f) => [`E1, in units of ${power(32 - 2 * f.exponent)}`, `E2, in units of 2 ${power(32 - f.exponent)}`],
    },
    "adiabatic-run": {
        title: "Theorem 3.3",
        of: (f) => `${delta(f.delta)}, every start at a height ${range(f.heights)} and any number n of bounces of the light mass alone, all at least ${f.margin} from the vertical: |I\u2099 \u2212 I\u2080| \u2264 ${f.bounds[0]} \u03b4.`,
        units: () => ["|I\u2099 \u2212 I\u2080|, in units of \u03b4"],
    },
    "adiabatic-scattering": {
        title: "Theorem 3.5",
        of: (f) => `${delta(f.delta)} and every whole scattering whose first and last bounce are at least ${f.margin} \u221a\u03b4 from the vertical: |I\u2099 \u2212 I\u2080| \u2264 ${f.bounds[0]} \u221a\u03b4, and the heavy mass is not touched.`,
        units: () => ["|I\u2099 \u2212 I\u2080|, in units of \u221a\u03b4"],
    },
};

/// The orbit of an attained state from collision 0 on: |phi'| = 1 and y' = -delta s before it, at u from the vertical.
function attainedOrbit({ u, s, delta }) {
    const [angle, steep, d] = [u, s, delta].map((x) => toNumber(parse(x)));
    const r = (d * d) / (1 - d * d);
    const psi = Math.PI - angle;
    return orbitFromContact(1 / r, { psi, y: Math.cos(angle), vpsi: 1, vy: -d * steep * (1 + r) }, false);
}

function attained(file) {
    const player = new Player();
    const about = h("p", { class: "note" });
    const load = (i) => {
        const state = file.attained[i];
        const orbit = attainedOrbit(state);
        player.load(orbit);
        about.replaceChildren(
            h("strong", {}, "Claimed by the file: "),
            `the state u = ${shortened(state.u)}, s = ${shortened(state.s)}, \u03b4 = ${shortened(state.delta)} before collision 0 has the error ${state.value} or more after ${plural(state.n, "further collision")}. `,
            h("strong", {}, "Computed by this page: "),
            `the motion, in double precision, as an illustration; it goes on to its last collision.`,
        );
    };
    load(0);
    const choice = file.attained.length > 1 ? h("div", { class: "controls" }, labelled("State", select(file.attained.map((_, i) => [i, `of E${i + 1}`]), 0, (i) => load(Number(i))))) : null;
    return h("figure", { class: "wide" }, choice, about, player.element);
}

function boxes(file) {
    return new Cover({
        title: `The boxes of the cover of ${file.name}`,
        choices: [{ text: "cover", tree: file.tree, chart: null, explain: "box", marks: null }],
        kinds: file.kinds,
        axisText: { u: "u: distance of the rod from the vertical", s: "s: \u2212y\u2032 over \u03b4", v: "v: distance after the last bounce", delta: "\u03b4: square root of the light mass" },
        describe: (kind) => (kind.reason === "outside" ? "outside: no state of the claim lies here" : `bound: the error is at most the constant, by class ${kind.class}`),
        file: file.verify_file,
        colourings: [{
            text: "by class",
            paint: (kind) => shade(kind.colour),
            label: (kind) => (kind.reason === "outside" ? "outside" : file.classes > 1 ? `bound by class ${kind.class}` : "bound"),
            order: (kind) => kind.class ?? 1e9,
        }],
    }).element;
}

export function adiabaticSection(file, isAlone) {
    const { title, of, units } = statements[file.claim];
    const rows = units(file).map((unit, i) => {
        const [bound, value] = [file.bounds[i], file.attained[i].value];
        return [unit, bound, value, Number(value) > 0 ? show(Number(bound) / Number(value), 4) : "\u2013"];
    });
    return [
        heading(file, `The adiabatic invariant: ${title}`),
        h("p", { class: "claim" }, of(file)),
        h("h3", {}, "What is attained"),
        attained(file),
        verifyBox(file),
        h("h3", {}, "The cover"),
        boxes(file),
        h("h3", {}, "Constants"),
        table("C rounded up, B down; exact in the file", ["what is bounded", "C, claimed", "B, attained", "C/B"], rows, [1, 2, 3]),
        table("Leaves of all trees", ["kind", "leaves"], [["bound", file.leaves.bound.toLocaleString("en")], ["outside", file.leaves.outside.toLocaleString("en")]], [1]),
        foundations(file, isAlone),
    ];
}
