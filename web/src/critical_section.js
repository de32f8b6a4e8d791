// A table of critical ratios: no certificate, and nothing to draw.
import { command, h, longTable, table } from "./dom.js";

export function criticalSection(file) {
    const { rows } = file;
    const last = rows.at(-1);
    const cells = rows.map(({ n, q_c: q, radius, orbit, flight }) => [String(n), q, radius === "0" ? "exact" : radius, `${orbit}, flight ${flight}`]);
    return [
        h("h2", {}, `Critical mass ratios, N = ${rows[0].n} to ${last.n}`),
        h("p", { class: "claim" }, "At the critical ratio q_c(N) the maximum steps from N \u2212 1 to N. Digits are cut off, not rounded; q_c lies within the radius of the number."),
        h(
            "div",
            { class: "verify" },
            h("p", {}, "This is a table, no certificate: it rests on Theorem 2 of proofs/theorem.md, which no cover uses, and no verifier checks it. This command makes it again:"),
            command(file.again),
        ),
        longTable("The table", ["N", "q_c(N)", "radius", "tangent there"], cells, [0], 100),
        table("The file", null, [["file", file.name], ["SHA-256 of its text", h("code", { class: "hash" }, file.sha256)]]),
    ];
}
