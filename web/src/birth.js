// How the N-th collision is born: the two extremal orbits of proofs/theorem.md while q moves through the ratios at which the
// greatest number of collisions steps. In doubles, as an illustration.
import { h, output } from "./dom.js";
import { plural, show } from "./numbers.js";
import { PhaseView } from "./phase_view.js";
import { parse, toNumber } from "./rational.js";
import { longestOrbit, nextStep } from "./witness.js";

const greatest = 1e4; // beyond it an orbit has too many collisions to see one more
const steps = 2000; // of the slider
const beside = 1e-4; // relatively: how far from a step the buttons stop

/// The ratios that the slider moves over: the certificate's, or around its only one; null if they are too great.
function range(file) {
    const [lo, hi] = [toNumber(parse(file.pieces[0].lo)), toNumber(parse(file.pieces.at(-1).hi))];
    const [from, to] = lo < hi ? [lo, hi] : [Math.max(1, lo / 2), lo * 2];
    return from < greatest ? { from, to: Math.min(to, greatest) } : null;
}

/// turned(q) is called when q is another.
export function birth(file, turned) {
    const ends = range(file);
    if (!file.has_orbits || ends === null) {
        return null;
    }
    const view = new PhaseView();
    const told = output("readout");
    const slider = h("input", { type: "range", min: 0, max: steps, step: 1, class: "scrub", "aria-label": "Mass ratio q", oninput: () => turn(at(Number(slider.value))) });
    const value = h("strong", { class: "value" });
    const at = (i) => ends.from * (ends.to / ends.from) ** (i / steps);
    let q = 0;
    function turn(next) {
        q = Math.min(ends.to, Math.max(ends.from, next));
        slider.value = Math.round((steps * Math.log(q / ends.from)) / Math.log(ends.to / ends.from));
        value.textContent = `q = ${show(q, 6)}`;
        slider.setAttribute("aria-valuetext", value.textContent);
        const { longest, other, name } = longestOrbit(q);
        view.setOrbit(longest, other);
        view.plane.draw();
        turned(q);
        told.textContent = `q = ${show(q, 8)}: the longest orbit, ${name}, has ${plural(longest.collisions.length, "collision")}; the other one (faint) ${other.collisions.length}.`;
    }
    const jump = (text, by) => h("button", { type: "button", onclick: () => {
        const step = nextStep(q, by, ends);
        turn(step === null ? (by > 0 ? ends.to : ends.from) : step * (1 + by * beside));
    } }, text);
    turn(Math.sqrt(ends.from * ends.to));
    return h("figure", { class: "wide birth" },
        h("div", { class: "controls transport" }, value, show(ends.from, 4), slider, show(ends.to, 4), jump("\u25c0 Step before", -1), jump("Next step \u25b6", 1)),
        view.element, told,
        h("figcaption", {}, "Move q. Just below a step the faint orbit\u2019s first and last flights pass close above the floor curve; at the step they touch it, and from then on that orbit is the longest: it has gained a collision at either end. Computed by this page in double precision."));
}
