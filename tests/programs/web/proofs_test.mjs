// The prover as WebAssembly, under node: it makes the program's certificates, byte for byte, and says what it does not decide.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import test from "node:test";
import { call, lines, moduleFrom } from "../../../web/src/modules/module.js";
import { certificates, dataIn, dumbbell, report, scratch, shipped } from "../page/program.mjs";

const module = await moduleFrom(readFileSync(process.env.DUMBBELL_WEB_PROVER).toString("base64"));
const place = scratch();
const asked = async (...words) => JSON.parse(await call(module, "certify", lines(words), () => {}));

const ratios = ["1", "1/7", "4.61", "4.603338848751700352556582029103016513067", "10", "27", "99/10", "1e2", "123456.789", "1e6", "31415926.5", "999999937", "1e9",
    "1:2", "1:10", "4.6:4.7", "50:60", "1:100", "900:1000", "1:1000"].map((ratio) => [["ratio", ratio], [ratio]]);
const rods = [["10", "1/100"], ["10", "1"], ["3", "1/2"], ["100", "1/1000"], ["1", "2"]].map(([ratio, mass]) => [["rod", ratio, mass], [ratio, "--rod-mass", mass]]);
const bodies = [["1", "4"], ["1", "3"], ["1", "2"], ["1/2", "9"], ["1/3", "3:30"], ["1/10", "40"]].map(([rho, inertia]) => [["body", rho, inertia], ["--rho", rho, "--inertia", inertia]]);

for (const [words, options] of [...ratios, ...rods, ...bodies]) {
    test(`${words.join(" ")}: the program's certificate, its command and its claim`, async () => {
        const { certificate, claim, command } = await asked(...words);
        dumbbell("certify", ...options, "--quiet", "--out", place("native.dbc"));
        assert.equal(certificate, readFileSync(place("native.dbc"), "utf8"));
        assert.equal(dumbbell("verify", ...claim.split(" "), place("native.dbc")).match(/^s VERIFIED /m)?.length, 1, claim);
        const again = command.split(" ").slice(1);
        dumbbell(...again, "--quiet", "--out", place("again.dbc"));
        assert.equal(certificate, readFileSync(place("again.dbc"), "utf8"), command);
    });
}

test("what is beyond the page is said, with the command that does it", async () => {
    for (const [ratio, command] of [["1e9:1e9", null], ["1000000001", "dumbbell certify 1000000001"], ["1:1001", "dumbbell certify 1:1001 --gap 1e-6"]]) {
        const answer = await asked("ratio", ratio);
        assert.equal("certificate" in answer, command === null, ratio);
        assert.ok(command === null || (answer.command === command && /up to 10\^9, and ranges up to 1:1000/.test(answer.why)), JSON.stringify(answer));
    }
});

test("what is no question is said, and nothing proved", async () => {
    for (const [words, said] of [[["ratio", "ten"], /'ten' is not a number/], [["ratio", "9:2"], /reversed/], [["ratio", "1e400"], /beyond 10\^100/], [["rod", "1:2", "1"], /one mass ratio/], [["rod", "2", "-1"], /negative/], [["body", "2", "1"], /swap the ends/]]) {
        const { usage, ...rest } = await asked(...words);
        assert.match(usage, said);
        assert.deepEqual(rest, {});
    }
});

const shown = async (name, bytes) => JSON.parse(await call(module, "show", Buffer.concat([Buffer.from(`${name}\n`), bytes]), () => {}));

for (const [name, file] of Object.entries({ ...certificates(place), body: shipped("body-1e6.dbc"), stairs: shipped("stairs-1-1e6.dbc.gz") })) {
    test(`of a file it gives what dumbbell report puts into a page: ${name}`, async () => {
        assert.deepEqual(await shown(basename(file), readFileSync(file)), dataIn(report(place("page.html"), file)));
    });
}

test("a damaged file is named", async () => {
    const text = readFileSync(shipped("stairs-1-100.dbc"), "utf8").replace("upper 4", "upper 3");
    assert.match((await shown("stairs.dbc", Buffer.from(text))).usage, /stairs\.dbc/);
});
