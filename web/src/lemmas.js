// What the claims rest on: the lemmas of proofs/, in a line each.

const lemmas = {
    L0: "The model: a point above the floor curve, reflected elastically in the metric d\u03c8\u00b2 + q dy\u00b2",
    L1: "No return: a flight never meets the hump that it leaves",
    L2: "One cell, and the turning collision",
    L3: "Steep rays leave: an ascending ray of slope at least 1 never collides again",
    L4: "The flight to a light wall and the reflection there",
    L5: "Monotone step: a lower, flatter ray never has fewer collisions left",
    L6: "The heavy mass touches the floor at most once; bounds for the rays at that contact",
    L7: "Equal masses: N(1) = 2",
    L8: "Chart bridge: contacts of the heavy mass",
    L9: "Chart light: turning collisions of the light mass",
    L10: "The first step of a descending ray, jointly in the mass ratio",
    L11: "Witness: an orbit that has so many collisions",
    L12: "Contacts and misses by tangents",
    L13: "Directed rounding by neighbours",
    L14: "Sine and cosine in double",
    L15: "All collision states, counted forward",
    L16: "Plain interval evaluation, without monotonicity",
    L19: "The heavy mass at most once, for every state of a box",
    L21: "The two extremal orbits: k1 \u2264 k0 \u2264 1 + k1, N(q) = 2 + k0 + k1 (Theorem 1)",
    L40: "Corners cost nothing: a motion on a stretch of time has at most N(q) collisions",
    L60: "A start\u2019s flights from contact to contact",
    L61: "The natural measure on incoming trajectories",
    L70: "A rigid body: L0 with two numbers, Q and \u03c1",
    L71: "All its collision states, counted forward",
    L72: "Symmetric bodies (\u03c1 = 1) have \u2308\u03c0/corner\u2309 collisions",
    L73: "So many collisions are possible close to the corner of any body",
    L74: "Witness: a body\u2019s orbit that has so many collisions",
    L75: "Q\u03c1 = 1 is the massless dumbbell",
    L78: "Any body\u2019s motion has one passage through a valley, on one side of the bridge",
    L79: "Comparison in the valley: a lower, steeper flight hits at least as often",
    L80: "How many collisions a passage has, by angles",
    L81: "The two tangents of the bridge: f does not decrease with e, b does not increase",
    L82: "The corner\u2019s ray from below",
    L83: "More Q, no fewer collisions",
    L86: "Orbits that leave a wall of the valley at a right angle",
    L87: "Bounds by a few of these orbits, of a range of Q and \u03c1",
};

const pages = [[15, "proofs/lemmas.md"], [20, "proofs/lemmas-sections.md"], [33, "proofs/theorem.md"], [70, "proofs/lemmas.md"], [86, "proofs/body.md"], [99, "proofs/plane.md"]];
const numerical = ["L12", "L13", "L14"];

const starts = ["L0", "L1", "L2", "L3", "L4", "L5", "L6", "L7", ...numerical, "L21", "L40", "L60"];

const sets = {
    turning: ["L0", "L1", "L2", "L3", "L4", "L5", "L6", "L8", "L9", "L10", "L11", ...numerical],
    full: ["L0", "L1", "L2", "L3", "L4", "L5", "L6", "L10", "L11", ...numerical, "L15", "L19"],
    plain: ["L0", "L1", "L2", "L3", "L4", "L6", "L11", ...numerical, "L15", "L16", "L19"],
    body: ["L1", "L2", "L3", "L4", "L6", ...numerical, "L16", "L70", "L71", "L72", "L73", "L74", "L75"],
    perpendicular: ["L1", "L2", "L3", "L4", "L5", ...numerical, "L70", "L73", "L74", "L78", "L79", "L80", "L81", "L82", "L83", "L86", "L87"],
    "initial-conditions": starts,
    incoming: [...starts, "L61"],
};

/// Rows [lemma, statement, page] for a file.
export function lemmaRows(file) {
    const isCollisions = file.claim === "collisions";
    const key = !isCollisions ? file.claim : file.scene !== "dumbbell" && file.section !== "perpendicular" ? file.scene : file.section;
    const names = [...sets[key]];
    if (isCollisions && file.pieces.some((piece) => piece.equal_masses)) {
        names.push("L7");
    }
    const number = (name) => Number(name.slice(1));
    names.sort((a, b) => number(a) - number(b));
    return names.map((name) => [name, lemmas[name], pages.find(([until]) => number(name) < until)[1]]);
}
