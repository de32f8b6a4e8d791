// The charts of a section (format.md, format-sections.md): what their axes mean.
import { sum } from "./counts.js";
import { show } from "./numbers.js";

const position = "e: angle from the corner";
const slope = "\u03b7: slope above the tangent";
const inUnits = ", in units of r = 1/q";
const contact = { t: "t: angle from the corner", eta: `${slope}${inUnits} (of a body: of \u03c1)` };

const charts = {
    bridge: { about: "contacts of the heavy mass with the floor", axes: { e: position, eta: contact.eta } },
    contact: { about: "contacts of the heavy mass with the floor that leave to the left", axes: contact },
    again: { about: "the same contacts once more: none of them comes back to the heavy mass", axes: contact },
    light: { about: "turning collisions of the light mass, of trajectories that never touch the floor with the heavy one", axes: { e: position, lambda: `\u03bb: slope${inUnits}` } },
    departure: { about: "collisions of the light mass, in any direction, that cross the cell next", axes: { e: position, eta: slope } },
};

export const chartAbout = (name) => charts[name].about;

export const axisLabel = (chart, name) => (name === "q" ? "q: mass ratio, heavy over light" : (charts[chart]?.axes[name] ?? name));

/// What the leaf of a file about mass ratios says, in a line.
export function leafText(kind, chart) {
    const forward = `at most ${kind.forward} later`;
    if (kind.reason !== "count") {
        return `${kind.reason}: ${kind.about}`;
    }
    return chart === "contact" || chart === "departure"
        ? `count ${kind.forward}: ${forward} collisions, so at most ${sum(1, kind.forward)} from here on`
        : `count ${kind.forward} ${kind.backward}: ${forward} and ${kind.backward} earlier collisions, so at most ${total(kind)} in all`;
}

export const total = (kind) => sum(1, kind.forward, kind.backward);

/// A box in words: `e 0.5 to 1, ...`; axes without width as one value.
export const boxText = (axes, box) =>
    axes
        .map(({ name }, a) => [name, box[2 * a], box[2 * a + 1]])
        .filter(([, lo, hi]) => lo !== 0 || hi !== 0)
        .map(([name, lo, hi]) => (lo === hi ? `${name} = ${show(lo, 8)}` : `${name} ${show(lo, 8)} to ${show(hi, 8)}`))
        .join(", ");
