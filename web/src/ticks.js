// Where an axis has its marks.
import { show } from "./numbers.js";

/// A round step for about `wanted` marks.
export function roundStep(span, wanted) {
    const raw = span / wanted;
    const power = 10 ** Math.floor(Math.log10(raw));
    return power * ([1, 2, 5].find((m) => m * power >= raw) ?? 10);
}

/// Marks {at, text} in [lo, hi], with as many digits as tell them apart; no closer than `least`.
export function linearTicks(lo, hi, wanted, least = 0) {
    const step = Math.max(least, roundStep(hi - lo, wanted));
    const size = Math.max(Math.abs(lo), Math.abs(hi));
    const digits = Math.max(1, Math.ceil(Math.log10(size / step)) + 1);
    const ticks = [];
    for (let i = Math.ceil(lo / step); i * step <= hi * (1 + 1e-12) && ticks.length < 50; ++i) {
        ticks.push({ at: i * step, text: size >= 1e5 && step >= 1e3 ? powers(i * step, digits) : show(i * step, Math.min(17, digits)) });
    }
    return ticks;
}

/// 400000 as 4e5.
const powers = (x, digits) => (x === 0 ? "0" : Number(x.toPrecision(digits)).toExponential().replace("e+", "e").replace(/-/g, "\u2212"));

/// Counts: whole numbers only.
export const countTicks = (lo, hi, wanted) => linearTicks(lo, hi, wanted, 1);

/// An axis of log10 q, with marks at round q: 1, 2, 5 of each decade, or equal steps of q in a narrow window.
export function logTicks(lo, hi, wanted) {
    const from = 10 ** lo;
    const to = 10 ** hi;
    if (to / from < 8) {
        return linearTicks(from, to, wanted).map(({ at, text }) => ({ at: Math.log10(at), text }));
    }
    const factors = hi - lo > wanted / 2 ? [1] : [1, 2, 5];
    const ticks = [];
    for (let decade = Math.floor(lo); decade <= hi; ++decade) {
        for (const factor of factors) {
            const at = decade + Math.log10(factor);
            if (at >= lo - 1e-9 && at <= hi + 1e-9) {
                ticks.push({ at, text: show(factor * 10 ** decade, 3) });
            }
        }
    }
    return ticks;
}

/// Angles: multiples of pi/2 and pi/4, in a narrow window decimals.
export function angleTicks(lo, hi, wanted) {
    const names = new Map([[0, "0"], [1, "\u03c0/4"], [2, "\u03c0/2"], [3, "3\u03c0/4"], [4, "\u03c0"]]);
    const name = (k) => names.get(k) ?? (k % 4 === 0 ? `${k / 4}\u03c0` : k % 2 === 0 ? `${k / 2}\u03c0/2` : `${k}\u03c0/4`);
    const quarters = (hi - lo) / (Math.PI / 4);
    if (quarters < 1.6) {
        return linearTicks(lo, hi, wanted);
    }
    const step = [1, 2, 4, 8, 16, 32].find((s) => quarters / s <= wanted + 1) ?? Math.ceil(quarters / wanted);
    const ticks = [];
    for (let k = Math.ceil(lo / (Math.PI / 4) / step) * step; k * (Math.PI / 4) <= hi; k += step) {
        ticks.push({ at: k * (Math.PI / 4), text: (k < 0 ? "\u2212" : "") + name(Math.abs(k)) });
    }
    return ticks;
}
