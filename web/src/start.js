// What a user types as a start.

/// `1.5`, `-1/3`, `2e3`; NaN for anything else.
export function numberFrom(text) {
    const match = /^\s*([-+\u2212]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(?:\/\s*(\d+\.?\d*))?\s*$/.exec(text);
    return match ? Number(match[1].replace("\u2212", "-")) / (match[2] ? Number(match[2]) : 1) : NaN;
}

/// What is wrong with a start of numbers; null if nothing is. Below 1, q is the ratio of swapped masses.
export function fault({ q, phi, phidot, y, ydot }) {
    if (![q, 1 / q, phi, phidot, y, ydot].every(Number.isFinite) || q < 0) {
        return "The mass ratio must be greater than 0, and each number one that doubles can hold.";
    }
    const r = Math.min(q, 1 / q);
    if (y + Math.sin(phi) / (1 + r) <= 0 || y - (r * Math.sin(phi)) / (1 + r) <= 0) {
        return "Both masses must start above the floor: choose a greater height y.";
    }
    return phidot === 0 && ydot === 0 ? "A dumbbell at rest stays at rest: give it a velocity." : null;
}
