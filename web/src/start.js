// What a user types as a start.

/// `1.5`, `-1/3`, `2e3`; NaN for anything else.
export function numberFrom(text) {
    const match = /^\s*([-+\u2212]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(?:\/\s*(\d+\.?\d*))?\s*$/.exec(text);
    return match ? Number(match[1].replace("\u2212", "-")) / (match[2] ? Number(match[2]) : 1) : NaN;
}

/// What is wrong with a start; null if nothing is.
export function fault({ q, phi, phidot, y, ydot }) {
    if (![q, phi, phidot, y, ydot].every(Number.isFinite)) {
        return "Write numbers like 3, \u22120.5, 1/3 or 1e4.";
    }
    if (q < 1) {
        return "The mass ratio q is heavy over light: at least 1.";
    }
    const r = 1 / q;
    if (y + Math.sin(phi) / (1 + r) <= 0 || y - (r * Math.sin(phi)) / (1 + r) <= 0) {
        return "Both masses must start above the floor: choose a greater height y.";
    }
    return phidot === 0 && ydot === 0 ? "A dumbbell at rest stays at rest: give it a velocity." : null;
}
