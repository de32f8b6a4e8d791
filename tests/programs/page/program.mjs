// The program under test, and certificates that it makes.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../../..", import.meta.url));
export const shipped = (name) => join(root, "certificates", name);

export const dumbbell = (...words) =>
    execFileSync(process.env.DUMBBELL_BIN, words.map(String), { encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "pipe"] });

/// A new folder, removed at the end.
export function scratch() {
    const folder = mkdtempSync(join(tmpdir(), "dumbbell-page-"));
    process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
    return (name) => join(folder, name);
}

/// 1,771 pieces: what a page costs that has many.
export const long = shipped("stairs-1-1e6.dbc.gz");

/// Certificates of every kind, of which pages are made.
export function certificates(place) {
    const starts = place("starts.dbc");
    dumbbell("trace", 10, "--phi", "0:3", "--phidot", "-1/2:1/2", "--y", "3/2", "--ydot", "-1", "--subdivide", "--max-boxes", 2000, "--out", starts);
    const solid = place("solid.dbc");
    dumbbell("trace", 10, "--phi", "0:3", "--phidot", "-1/2:1/2", "--y", "3/2:2", "--ydot", "-1", "--subdivide", "--max-boxes", 500, "--out", solid);
    const incoming = place("incoming.dbc");
    dumbbell("trace", 10, "--incoming", "--subdivide", "--max-boxes", 2000, "--out", incoming);
    const fine = place("fine.dbc");
    dumbbell("certify", "4.6:4.7", "--gap", "1e-40", "--out", fine);
    return {
        stairs: shipped("stairs-1-100.dbc"),
        ten: shipped("q-10.dbc"),
        one: shipped("q-1.dbc"),
        full: shipped("full-100.dbc.gz"),
        plain: shipped("full-plain-10.dbc.gz"),
        coin: shipped("coin.dbc"),
        rod: shipped("rod-10.dbc.gz"),
        starts,
        solid,
        incoming,
        fine,
    };
}

export function report(out, ...files) {
    dumbbell("report", ...files, "--no-verifier", "--out", out);
    return out;
}

/// The data in a page.
export function dataIn(file) {
    const page = readFileSync(file, "utf8");
    const begin = page.indexOf('id="data">') + 'id="data">'.length;
    return JSON.parse(page.slice(begin, page.indexOf("</script>", begin)));
}
