// The charts of a section (format.md, format-sections.md): what their axes mean, and where their states are in the plane of
// psi and the slope d yhat / d psi in the direction of travel.
import { sum } from "./counts.js";
import { show } from "./numbers.js";

const bridge = {
    about: "contacts of the heavy mass with the floor",
    axes: { e: "e: angle from the corner", eta: "\u03b7: slope above the tangent, in units of r = 1/q (of a body: of \u03c1)" },
    psi: (e) => Math.PI / 2 - e,
    position: (psi) => Math.PI / 2 - psi,
    slope: (e, eta, r) => r * (Math.cos(e) + eta),
    steepness: (e, slope, r) => slope / r - Math.cos(e),
    limit: Math.PI / 2,
};
const contact = {
    ...bridge,
    about: "contacts of the heavy mass with the floor that leave to the left",
    axes: { t: "t: angle from the corner", eta: bridge.axes.eta },
    limit: Math.PI,
};
const light = {
    about: "turning collisions of the light mass, of trajectories that never touch the floor with the heavy one",
    axes: { e: "e: angle from the corner", lambda: "\u03bb: slope in units of r = 1/q" },
    psi: (e) => Math.PI / 2 + e,
    position: (psi) => psi - Math.PI / 2,
    slope: (e, lambda, r) => r * lambda,
    steepness: (e, slope, r) => slope / r,
    limit: Math.PI / 2,
};

const charts = {
    bridge,
    contact,
    again: { ...contact, about: "the same contacts once more: none of them comes back to the heavy mass" },
    light,
    departure: {
        ...light,
        about: "collisions of the light mass, in any direction, that cross the cell next",
        axes: { e: light.axes.e, eta: "\u03b7: slope above the tangent" },
        slope: (e, eta) => eta - Math.cos(e),
        steepness: (e, slope) => slope + Math.cos(e),
    },
    wedge: {
        about: "slopes of turning collisions; the wedge has no scale, so no position",
        axes: { lambda: "\u03bb: slope in units of r = 1/q", e: "" },
        psi: null, // no physical coordinates
    },
};

export const chartNamed = (name) => charts[name];

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
