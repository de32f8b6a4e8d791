// Colours that stay apart for those who see fewer of them: cividis for counts, Okabe and Ito's set for kinds.

const cividis = [
    [0, 34, 78], [18, 53, 112], [59, 73, 108], [87, 93, 109], [112, 113, 115],
    [138, 134, 120], [165, 157, 116], [196, 182, 102], [229, 207, 82], [254, 232, 56],
];

/// t in [0, 1], dark to bright.
export function sequential(t) {
    const at = Math.min(1, Math.max(0, t)) * (cividis.length - 1);
    const i = Math.min(cividis.length - 2, Math.floor(at));
    const mix = (a, b) => Math.round(a + (b - a) * (at - i));
    const [r, g, b] = cividis[i].map((part, k) => mix(part, cividis[i + 1][k]));
    return `rgb(${r},${g},${b})`;
}

const categories = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442"];

export const categorical = (i) => categories[i % categories.length];
