// The verifier as WebAssembly, under node: of every shipped certificate and every committed false claim it says what dumbbell-verify
// says, work counts included. With DUMBBELL_TEST_SCALE=20 of the law's certificate, too.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";
import { call, lines, moduleFrom } from "../../../web/src/modules/module.js";

const root = fileURLToPath(new URL("../../..", import.meta.url));
const module = await moduleFrom(readFileSync(process.env.DUMBBELL_WEB_VERIFIER).toString("base64"));

const rows = (list, folder) =>
    readFileSync(join(root, list), "utf8").split("\n").filter((line) => line !== "" && !line.startsWith("#")).map((line) => line.split("\t"))
        .map(([file, options]) => [join(root, folder, file), options.split(" ").filter((word) => word !== "")]);

const claims = rows("certificates/claims.tsv", "certificates").filter(([file]) => process.env.DUMBBELL_TEST_SCALE >= 20 || !file.endsWith("law.dbc.gz"));
const lies = rows("tests/attacks/false_claims/manifest.tsv", "tests/attacks/false_claims");

function native(options, file) {
    try {
        return execFileSync(process.env.DUMBBELL_VERIFY, ["--jobs", "1", ...options, file], { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
    } catch (error) { // it was not verified
        return error.stdout;
    }
}

/// Reads at most `most` bytes at a time.
function reader(bytes, most = Infinity) {
    let at = 0;
    return (size) => {
        const some = bytes.subarray(at, at + Math.min(size, most));
        at += some.length;
        return some;
    };
}
const verify = async (options, read, progress = () => {}) => JSON.parse(await call(module, "verify", lines(options), progress, read));
const here = (options, bytes, most) => verify(options, reader(bytes, most));

async function agree(file, options) {
    const said = await here(options, readFileSync(file));
    const [asJson] = JSON.parse(native(["--json", ...options], file));
    assert.deepEqual({ ...said.result, file: "" }, { ...asJson, file: "" });
    const lines = native(options, file).trimEnd().split("\n");
    assert.equal(said.line, lines.at(-1));
    assert.equal(said.sentence.trimEnd(), lines.slice(1, -1).join("\n"));
}

test("there are certificates and false claims to ask about", () => assert.ok(claims.length > 10 && lies.length > 150));

for (const [file, options] of [...claims, ...lies]) {
    test(`${file.slice(root.length)} ${options.join(" ")}`, () => agree(file, options));
}

const ten = join(root, "certificates", "q-10.dbc");

test("options for precision and cost are those of the program", async () => {
    for (const options of [["--precision", "200"], ["--precision", "4096"], ["--budget", "0.00001s"], ["--max-bits", "53"], ["--budget=1h", "--precision=64"]]) {
        await agree(ten, options);
    }
});

test("a file that comes in small parts is the same file", async () => {
    for (const [name, most] of [["stairs-1-100.dbc", 1], ["stairs-1-1e4.dbc.gz", 100]]) {
        const bytes = readFileSync(join(root, "certificates", name));
        assert.deepEqual(await here([], bytes, most), await here([], bytes));
    }
});

test("what states no claim is said, and nothing verified", async () => {
    const bytes = readFileSync(ten);
    assert.deepEqual(await here(["--ratio", "ten"], bytes), { usage: "not a positive ratio: `ten`" });
    assert.deepEqual(await here(["--jobs", "2"], bytes), { usage: "unknown option --jobs" });
    assert.deepEqual(await here(["--max", "4", "--exactly", "4"], bytes), { usage: "--exactly N is --max N and --min N: give it without them" });
});

test("how far it is, is told", async () => {
    const told = [];
    await verify([], reader(readFileSync(join(root, "certificates", "stairs-1-1e4.dbc.gz"))), (...at) => told.push(at));
    assert.ok(told.length > 100 && told.every(([seconds, read, pieces], i) => pieces === 177 && read <= 177 && (i === 0 || seconds >= told[i - 1][0])));
});

test("a failing source is no end of the file", async () => {
    const broken = () => {
        throw new Error("gone");
    };
    await assert.rejects(verify([], broken), /gone/);
});
