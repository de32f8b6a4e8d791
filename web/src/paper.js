// The curves beside the staircase, for every q >= 1 (doubles: pictures only).

/// The source paper's bound ceil(pi / gamma) + 1 steps up from m + 1 to m + 2 behind q = cot^2(pi / 2m).
export const paperStep = (m) => (m === 2 ? 1 : m === 3 ? 3 : 1 / Math.tan(Math.PI / (2 * m)) ** 2);

/// The bound at q; pi / gamma = (pi / 2) / atan(1 / sqrt q).
export function paperBound(q) {
    let m = Math.max(2, Math.round(Math.PI / 2 / Math.atan(1 / Math.sqrt(q))));
    while (paperStep(m) < q) {
        ++m;
    }
    while (m > 2 && paperStep(m - 1) >= q) {
        --m;
    }
    return m + 1;
}

export const growth = (q, constant) => 2 + constant * Math.sqrt(q);
