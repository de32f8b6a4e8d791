// Colours that stay apart for those who see fewer of them: viridis for counts, as `dumbbell plot` has it
// (src/pictures/count_colours.cpp), Okabe and Ito's set for kinds. Colours with a name: style.css.

const viridis = [
    [253, 231, 37], [181, 222, 43], [110, 206, 88], [53, 183, 121], [31, 158, 137],
    [38, 130, 142], [49, 104, 142], [62, 73, 137], [72, 40, 120], [68, 1, 84],
];
const leastSteps = 3; // so that 1, 2, 3, 4 have the same colours in all pictures of few counts

/// t in [0, 1], bright to dark.
function sequential(t) {
    const at = Math.min(1, Math.max(0, t)) * (viridis.length - 1);
    const i = Math.min(viridis.length - 2, Math.floor(at));
    const [r, g, b] = viridis[i].map((part, k) => Math.round(part + (viridis[i + 1][k] - part) * (at - i)));
    return `rgb(${r},${g},${b})`;
}

/// The colour of a count >= 1 in a picture with counts from least to most; share: of the scale, as much as stands out from the page.
export function countColour(count, least, most, share = 1) {
    const first = Math.max(1, least);
    return sequential((share * (count - first)) / Math.max(leastSteps, most - first));
}

const categories = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442"];

export const categorical = (i) => categories[i % categories.length];
