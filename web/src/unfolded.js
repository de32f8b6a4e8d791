// Why ceil(pi/gamma), and why the dumbbell has fewer collisions: the wedge unfolded along a straight line, and the floor unfolded along
// the longest orbit. In the plane of psi and sqrt(q) y flights are straight, and walls are mirrors (L0, L17). In doubles, as an illustration.
import { h, output, s } from "./dom.js";
import { floorAt } from "./flight.js";
import { show } from "./numbers.js";
import { longestOrbit } from "./witness.js";

const greatest = 100; // mass ratio: beyond it the copies are too many to tell apart
const radius = 100; // of the corners around the vertex
const reach = 2; // radii: so far along a wall the floor beside it goes up
const [across, above, below] = [230, 175, 12]; // the vertex

const points = (places) => places.map((at) => at.map((x) => x.toFixed(2)).join(" ")).join("L");
const path = (kind, ...places) => s("path", { class: kind, d: `M${points(places)}` });
const dot = (kind, x, y) => path(`${kind} dot`, [x, y], [x, y]);
const written = (x, y, text) => s("text", { x, y: y - 7 }, text);
const picture = (label) => s("svg", { role: "img", "aria-label": label, viewBox: `${-across} ${-above} ${2 * across} ${above + below}` });

/// From a state of the dumbbell to its place, with the vertex of the wedge at 0.
const placing = (q) => (psi, y) => [psi, -Math.sqrt(q) * (y + Math.PI / 2)].map((x) => (x * radius) / (Math.PI / 2) / Math.sqrt(1 + q));

/// A stretch of the floor.
const curve = (q, from, to) => Array.from({ length: 33 }, (_, i) => from + ((to - from) * i) / 32).map((psi) => placing(q)(psi, floorAt(psi, 1 / q)));

function bridge(q) {
    const places = curve(q, -Math.PI / 2, Math.PI / 2);
    return [path("ground", [0, 0], ...places, [0, 0]), path("heavy", ...places)];
}

/// The line at this height above the vertex, as symmetric as can be. Gives what is drawn and said.
function wedge(q, height) {
    const gamma = 2 * Math.atan(1 / Math.sqrt(q));
    const walls = Math.ceil(Math.PI / gamma - 1e-9);
    const angles = Array.from({ length: walls }, (_, k) => (Math.PI - (walls - 1) * gamma) / 2 + k * gamma); // from the left end
    const at = (angle, far) => [-far * Math.cos(angle), -far * Math.sin(angle)];
    const shapes = [angles[0] - gamma, ...angles].map((angle) => s("g", { transform: `rotate(${((angle + gamma / 2) * 180) / Math.PI - 90})` }, bridge(q)));
    angles.forEach((angle) => shapes.push(path("beyond", [0, 0], at(angle, Math.min(across / Math.abs(Math.cos(angle)), above / Math.sin(angle)))), path("light", at(angle, radius), at(angle, reach * radius))));
    shapes.push(path("way", [-across, -height], [across, -height]));
    const isBelow = (x) => {
        const turn = Math.atan2(height, -x) - angles[0] + gamma; // into the first copy
        const angle = turn - gamma * (Math.floor(turn / gamma) + 0.5);
        const [psi, y] = [Math.sin(angle), Math.cos(angle)].map((part) => (part * Math.hypot(x, height) * Math.PI * Math.sqrt(1 + q)) / 2 / radius);
        return y < Math.sqrt(q) * (floorAt(psi, 1 / q) + Math.PI / 2);
    };
    const under = Array.from({ length: 2 * across }, (_, i) => i - across).filter(isBelow);
    if (under.length > 0) {
        shapes.push(path("below", [under[0], -height], [under.at(-1), -height]));
    }
    const crossings = angles.map((angle, k) => ({ number: k + 1, x: -height / Math.tan(angle), far: height / Math.sin(angle) }));
    const shown = crossings.filter(({ x }) => Math.abs(x) < across - 62);
    const numbers = (of) => `${of[0].number}${of.length > 1 ? ` to ${of.at(-1).number}` : ""}`;
    const left = crossings.slice(0, shown[0].number - 1);
    shapes.push(...crossings.filter(({ x }) => Math.abs(x) < across).map(({ x }) => dot("light", x, -height)), ...shown.map(({ number, x }) => written(x, -height, number)));
    if (left.length > 0) { // as many as on the right
        shapes.push(written(37 - across, -height, `\u2190 ${numbers(left)}`), written(across - 37, -height, `${numbers(crossings.slice(-left.length))} \u2192`));
    }
    const missing = crossings.filter(({ far }) => far > reach * radius);
    const degrees = show((gamma * 180) / Math.PI, 3);
    return {
        shapes,
        text: `q = ${show(q, 8)}${q === greatest ? ", the greatest that is drawn" : ""}: from the vertex the whole line is seen under 180\u00b0, and each copy of the wedge under \u03b3 = ${degrees}\u00b0. So it crosses \u2308180/${degrees}\u2309 = ${walls} walls at most. ${under.length > 0
            ? "But on the dashed stretch it would run below the bridge: there the dumbbell hits the floor with its heavy mass, and turns away."
            : missing.length > 0
              ? `It passes above all bridges. But it crosses the walls ${numbers(missing.slice(0, missing.length / 2))} and ${numbers(missing.slice(missing.length / 2))} where the dumbbell\u2019s floor does not reach: behind the thick part.`
              : "It passes above all bridges."}`,
    };
}

/// Each copy of the floor is the one before it, mirrored at the tangent of the contact. The bridge is only touched.
function dumbbell(q) {
    const { collisions, first } = longestOrbit(q).longest;
    let copy = new DOMMatrix().rotate((Math.atan((first.vy * Math.sqrt(q)) / Math.abs(first.vpsi)) * 180) / Math.PI).scale(Math.sign(first.vpsi), 1); // it flies to the right
    const copies = [copy];
    const contacts = collisions.map(({ psi, y, heavy }) => {
        const [x, z] = placing(q)(psi, y);
        const at = copy.transformPoint({ x, y: z });
        if (!heavy) {
            const angle = (-Math.atan(Math.sqrt(q) * Math.sin(psi)) * 180) / Math.PI;
            copy = copy.translate(x, z).rotate(angle).scale(1, -1).rotate(-angle).translate(-x, -z);
            copies.push(copy);
        }
        return { kind: heavy ? "heavy" : "light", x: at.x, y: at.y };
    });
    const middle = contacts.find(({ kind }) => kind === "heavy");
    const shift = new DOMMatrix().translate(-middle.x, -radius - middle.y);
    const humps = [path("light", ...curve(q, -Math.PI, -Math.PI / 2)), path("light", ...curve(q, Math.PI / 2, Math.PI))];
    return {
        shapes: [
            ...copies.map((of) => s("g", { transform: shift.multiply(of) }, bridge(q), humps.map((hump) => hump.cloneNode()))),
            path("way", [-across, -radius], [across, -radius]),
            ...contacts.map(({ kind, x, y }) => dot(kind, x - middle.x, y - middle.y - radius)),
            ...contacts.map(({ x }, i) => (Math.abs(contacts[i + 1]?.x - x) < 9 ? null : written(x - middle.x, -radius, Math.abs(contacts[i - 1]?.x - x) < 9 ? `${i}, ${i + 1}` : i + 1))),
        ],
        text: `The longest orbit of the dumbbell only touches the bridge. It hits the floor where that is flatter than the wedge, so each copy is turned by more than \u03b3, and the line leaves them after N = ${collisions.length} collisions.`,
    };
}

export class Unfolded {
    constructor() {
        this.parts = ["The wedge, unfolded: a straight line crosses copies of it", "The dumbbell\u2019s floor, unfolded along the longest orbit"].map((label) => ({ label, picture: picture(label), told: output("readout tall") }));
        this.height = h("input", { type: "range", min: 20, max: 160, value: 60, class: "scrub", "aria-label": "Distance of the line from the vertex", oninput: () => this.draw() });
        this.value = h("span", { class: "value" });
        const [wedges, floors] = this.parts.map(({ label, picture: shown, told }, i) => h("div", {}, h("p", { class: "note" }, h("strong", {}, label)), shown, i === 0 && h("label", { class: "controls" }, "Line nearer", this.height, "farther", this.value), told));
        this.element = h("figure", { class: "wide unfolded" }, h("div", { class: "halves" }, wedges, floors), h("figcaption", {}, "Instead of the path, mirror the wedge at the wall that is hit: the path goes straight on, into a copy. The walls of the wedge touch the floor at its corners, and are thick as far as the floor beside them goes up. Between the corners is the bridge, which the heavy mass hits; it cuts the vertex off. Computed by this page in double precision."));
        this.show(greatest);
    }

    show(q) {
        this.q = Math.min(q, greatest);
        this.draw();
    }

    draw() {
        this.value.textContent = `at ${Number(this.height.value) / radius} of a corner\u2019s distance`;
        [wedge(this.q, Number(this.height.value)), dumbbell(this.q)].forEach(({ shapes, text }, i) => {
            this.parts[i].picture.replaceChildren(...shapes.filter(Boolean));
            this.parts[i].told.textContent = text;
        });
    }
}
