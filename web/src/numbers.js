// Numbers as people read them.

/// About `digits` significant digits, without needless zeros; a true minus sign.
export function show(x, digits = 6) {
    if (x === 0) {
        return "0";
    }
    const size = Math.abs(x);
    const text =
        size >= 1e7 || size < 1e-4
            ? x.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e")
            : String(Number(x.toPrecision(digits)));
    return text.replace(/-/g, "\u2212");
}

export const plural = (n, word) => (n === 1 ? `1 ${word}` : `${n.toLocaleString("en")} ${word}s`);

/// A long number's first and last digits.
export const shortened = (text, most = 34) =>
    text.length <= most ? text : `${text.slice(0, most - 8)}\u2026${text.slice(-6)}`;
