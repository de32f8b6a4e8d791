// Numbers of collisions. Doubles hold integers exactly below 2^53 only; from there on the program writes a string, which is read
// as a BigInt.

const names = new Set(["upper", "lower", "forward", "backward", "least", "most"]);

/// JSON.parse with the counts of a report as what they are.
export const parseReport = (text) =>
    JSON.parse(text, (name, value) => (names.has(name) && typeof value === "string" ? BigInt(value) : value));

/// The sum, exactly.
export function sum(...counts) {
    const exact = counts.reduce((total, count) => total + BigInt(count), 0n);
    return exact > Number.MAX_SAFE_INTEGER ? exact : Number(exact);
}
