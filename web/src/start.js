// What a user types or pastes as a start.
import { show } from "./numbers.js";

/// `1.5`, `-1/3`, `2e3`; NaN for anything else.
export function numberFrom(text) {
    const match = /^\s*([-+\u2212]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(?:\/\s*(\d+\.?\d*))?\s*$/.exec(text);
    return match ? Number(match[1].replace("\u2212", "-")) / (match[2] ? Number(match[2]) : 1) : NaN;
}

/// As `dumbbell trace` reads it.
export const inLetters = (text) => text.replace(/\u2212/g, "-").replace(/\u03c0/g, "pi").replace(/\u00b0/g, "deg").replace(/[\s+]/g, "");

/// The same, or degrees (`30deg`), or a multiple of pi (`pi/2`, `-2pi/3`, `0.3pi`); in radians.
export function angleFrom(typed) {
    const text = inLetters(typed);
    const degrees = /^(.*\d)\s*deg\s*$/.exec(text);
    if (degrees) {
        return (numberFrom(degrees[1]) * Math.PI) / 180;
    }
    const multiple = /^\s*([-+\u2212]?)([\d.]*(?:[eE][-+]?\d+)?)pi(?:\/([\d.]+))?\s*$/.exec(text);
    return multiple ? (numberFrom(`${multiple[1]}${multiple[2] || "1"}`) * Math.PI) / numberFrom(multiple[3] ?? "1") : numberFrom(text);
}

/// The start of a command `dumbbell trace 10 --phi ... --phidot ... --y ... --ydot ...`, whatever stands before it, as its words; null
/// for anything else.
export function startFrom(text) {
    const words = text.trim().split(/[\s=]+/);
    const command = words.indexOf("trace");
    const after = (name) => (words.includes(name) ? words[words.indexOf(name) + 1] : undefined);
    const start = { q: words[command + 1], phi: after("--phi"), phidot: after("--phidot"), y: after("--y"), ydot: after("--ydot") };
    return command > 0 && Object.values(start).every((word) => word !== undefined) ? start : null;
}

const linkMark = "#start=";

/// What is behind the mark in an address: a link to this start.
export const linkTo = (words) => linkMark + words.map(encodeURIComponent).join(",");

/// The start of such a link; null of any other, and of one that is damaged.
export function linkedStart(hash) {
    try {
        const words = hash.startsWith(linkMark) ? hash.slice(linkMark.length).split(",").map(decodeURIComponent) : [];
        const [q, phi, phidot, y, ydot] = words;
        return words.length === 5 ? { q, phi, phidot, y, ydot } : null;
    } catch {
        return null;
    }
}

const most = { y: 1e6, phidot: 1e9, ydot: 1e9 }; // as `dumbbell trace` has them

/// What is wrong with a start of numbers; null if nothing is. Below 1, q is the ratio of swapped masses.
export function fault({ q, phi, phidot, y, ydot }) {
    if (![q, 1 / q, phi, phidot, y, ydot].every(Number.isFinite) || q < 0) {
        return "The mass ratio must be greater than 0, and each number one that doubles can hold.";
    }
    const great = Object.entries({ y, phidot, ydot }).find(([name, value]) => Math.abs(value) > most[name]);
    if (great) {
        return `${great[0]} is at most ${show(most[great[0]])} in absolute value, as for \u201cdumbbell trace\u201d.`;
    }
    const r = Math.min(q, 1 / q);
    if (y + Math.sin(phi) / (1 + r) <= 0 || y - (r * Math.sin(phi)) / (1 + r) <= 0) {
        return "Both masses must start above the floor: choose a greater height y.";
    }
    return phidot === 0 && ydot === 0 ? "A dumbbell at rest stays at rest: give it a velocity." : null;
}
