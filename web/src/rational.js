// Exact rationals {n, d} of BigInts, d > 0: what certificates write as `P/Q`.

export function parse(text) {
    const [n, d = "1"] = text.split("/");
    return { n: BigInt(n), d: BigInt(d) };
}

export const subtract = (a, b) => ({ n: a.n * b.d - b.n * a.d, d: a.d * b.d });

/// The exact value of a finite double.
export function fromNumber(x) {
    let d = 1n;
    while (!Number.isInteger(x)) {
        x *= 2;
        d *= 2n;
    }
    return { n: BigInt(x), d };
}

const bits = (n) => n.toString(16).length * 4;

/// A double within a few units of the last place.
export function toNumber({ n, d }) {
    if (n < 0n) {
        return -toNumber({ n: -n, d });
    }
    if (n === 0n) {
        return 0;
    }
    const shift = 64 - (bits(n) - bits(d)); // leaves at least 60 bits
    const quotient = shift >= 0 ? (n << BigInt(shift)) / d : n / (d << BigInt(-shift));
    return Number(quotient) * 2 ** -shift;
}

/// x >= 0 with `places` decimals, cut off.
export function toDecimal({ n, d }, places) {
    const scaled = ((n * 10n ** BigInt(places)) / d).toString().padStart(places + 1, "0");
    return places === 0 ? scaled : `${scaled.slice(0, -places)}.${scaled.slice(-places)}`;
}

/// The exact value of what toDecimal prints.
export function fromDecimal(text) {
    const [whole, part = ""] = text.split(".");
    return { n: BigInt(whole + part), d: 10n ** BigInt(part.length) };
}
