// verify.html, and a page of dumbbell report that contains the verifier, in headless Chromium, from disk.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import test, { after } from "node:test";
import { gzipSync } from "node:zlib";
import { launch, open } from "../page/browser.mjs";
import { dumbbell, root, scratch, shipped } from "../page/program.mjs";

const axe = readFileSync(join(root, "web", "node_modules", "axe-core", "axe.min.js"), "utf8");
const page = process.env.DUMBBELL_WEB_PAGE;
const place = scratch();
const browser = await launch();
after(() => browser.close());

const lie = (name) => join(root, "tests", "attacks", "false_claims", name);
const given = (name, bytes) => {
    writeFileSync(place(name), bytes);
    return place(name);
};

/// The page with these files, once all are done: the results' elements.
async function answers(tab, files) {
    await tab.locator("#files").setInputFiles(files);
    return ended(tab, files.length);
}
async function ended(tab, count) {
    const done = tab.locator(".outcome[data-outcome]");
    await tab.waitForFunction((n) => document.querySelectorAll(".outcome[data-outcome]").length === n, count);
    return done;
}
const quiet = (tab, file = page) => {
    assert.deepEqual(tab.complaints, []);
    assert.deepEqual(tab.requests.filter((url) => !url.startsWith("blob:")), [`file://${file}`]);
};
const onPage = (name, run, options) => test(name, async () => {
    const tab = await open(browser, page, options);
    await run(tab);
    quiet(tab);
    await tab.close();
});
async function claim(tab, bound, values) {
    await tab.getByLabel("this claim:").check();
    await tab.getByLabel("the greatest number of collisions is").selectOption(bound);
    for (const [id, value] of Object.entries(values)) {
        await tab.locator(`#${id}`).fill(value);
    }
    await tab.getByRole("button", { name: "Verify" }).click();
}

onPage("files of every kind say what they prove, with the program's verdict", async (tab) => {
    const done = await answers(tab, ["q-10.dbc", "stairs-1-1e4.dbc.gz", "coin.dbc", "full-1000.dbc.gz"].map(shipped));
    const texts = await done.allTextContents();
    assert.match(texts[0], /^Verified here, in your browser, in [\w\s.]+sProved: at mass ratio 10 no trajectory hits the floor more than 4 times, and some trajectory hits it 4 times/);
    assert.match(texts[0], /s VERIFIED scene=dumbbell ratio=10\/1:10\/1 upper=4 lower=4 gaps=0 open=0 sha256=[0-9a-f]{64} heavy|s VERIFIED scene=dumbbell ratio=10\/1:10\/1 upper=4 lower=4 gaps=0 open=0/);
    assert.match(texts[0], /SHA-256 of the file's text: [0-9a-f]{64}/);
    assert.match(texts[1], /known in \d+ of 177 pieces/);
    assert.match(texts[2], /motion of the body/);
    assert.ok(texts.every((text) => text.startsWith("Verified here")), texts.join());
});

onPage("a claim is stated in the form, and a file that proves less is rejected", async (tab) => {
    await answers(tab, [shipped("stairs-1-100.dbc")]);
    for (const [bound, values, verdict] of [
        ["at most", { ratio: "5:30", count: "6" }, "Verified here"],
        ["exactly", { ratio: "10", count: "4" }, "Verified here"],
        ["at most", { ratio: "1:100", count: "9" }, "Rejected"],
        ["at most", { ratio: "1:200", count: "20" }, "Rejected"],
        ["at most", { ratio: "ten", count: "4" }, "The claim cannot be read"],
        ["at most", { ratio: "1:100", count: "10", more: "--min 2  --gap 1e-6 --gaps 8" }, "Verified here"],
        ["at most", { more: "--gap 1e-9" }, "Rejected"],
        ["at most", { more: "--claim law" }, "The claim cannot be read"],
        ["at most", { more: "--jobs 2" }, "The claim cannot be read"],
    ]) {
        await claim(tab, bound, values);
        const [text] = await (await ended(tab, 1)).allTextContents();
        assert.ok(text.startsWith(verdict), `${bound} ${JSON.stringify(values)}: ${text}`);
    }
    await tab.locator("#count").fill(""); // an edited claim has no verdict, and one without a number is none
    assert.equal(await tab.locator(".outcome").count(), 0);
    await claim(tab, "exactly", { more: "" });
    assert.match(await tab.getByRole("alert").textContent(), /has no number/);
    await tab.getByLabel("Of", { exact: true }).selectOption("a rigid body");
    assert.equal(await tab.locator(".outcome, [role=alert]").count(), 0);
    await tab.locator("#files").setInputFiles([shipped("coin.dbc")]);
    for (const [inertia, verdict] of [["4", "Verified here"], ["3:4", "Rejected"]]) {
        await claim(tab, "exactly", { inertia, rho: "1", count: "4" });
        assert.ok((await (await ended(tab, 1)).allTextContents())[0].startsWith(verdict), inertia);
    }
});

onPage("a file is dropped anywhere on the page", async (tab) => {
    const data = await tab.evaluateHandle((text) => {
        const dropped = new DataTransfer();
        dropped.items.add(new File([text], "dropped.dbc"));
        return dropped;
    }, readFileSync(shipped("q-100.dbc"), "utf8"));
    await tab.dispatchEvent("body", "drop", { dataTransfer: data });
    const [text] = await (await ended(tab, 1)).allTextContents();
    assert.match(text, /^Verified here.* more than 10 times/);
});

onPage("hostile files get an answer or a limit, and the page stays alive", async (tab) => {
    const text = readFileSync(shipped("stairs-1-100.dbc"));
    const files = [
        lie("less-deep-10.dbc"),
        lie("tree-void.dbc"),
        given("empty.dbc", ""),
        given("noise.dbc", Buffer.from(Array.from({ length: 100_000 }, (_, i) => (i * i * 7919) % 251))),
        given("cut.dbc.gz", gzipSync(text).subarray(0, 400)),
        given("bomb.dbc.gz", gzipSync(Buffer.alloc(200_000_000, "split x\n"))),
        given("line.dbc", Buffer.alloc(5_000_000, "9")),
        given("<img src=x onerror=alert(1)>.dbc", text),
    ];
    const texts = await (await answers(tab, files)).allTextContents();
    assert.deepEqual(texts.map((said) => said.match(/^[A-Z][a-z]+/)[0]), ["Rejected", "Rejected", "Rejected", "Rejected", "Rejected", "Rejected", "Rejected", "Verified"]);
    assert.equal(await tab.locator("img").count(), 0);
});

onPage("a long verification tells how far it is, leaves the page alive, and can be stopped", async (tab) => {
    await tab.locator("#files").setInputFiles([shipped("law.dbc.gz"), shipped("q-10.dbc")]);
    await tab.waitForFunction(() => /Verifying: /.test(document.querySelector(".state").textContent));
    await tab.locator("article").first().getByRole("button", { name: "Stop" }).click();
    const texts = await (await ended(tab, 2)).allTextContents();
    assert.equal(texts[0], "Stopped");
    assert.match(texts[1], /^Verified here/); // in another worker
});

test("the policy forbids every request, also one that the page would make", async () => {
    const tab = await open(browser, page);
    const outcomes = await tab.evaluate(() => Promise.all([
        fetch("https://example.org/").then(() => "fetched", () => "refused"),
        new Promise((resolve) => Object.assign(new Image(), { onload: () => resolve("loaded"), onerror: () => resolve("refused") }).src = "https://example.org/x.png"),
        new Promise((resolve) => document.body.append(Object.assign(document.createElement("script"), { onload: () => resolve("loaded"), onerror: () => resolve("refused"), src: "https://example.org/x.js" }))),
    ]));
    assert.deepEqual(outcomes, ["refused", "refused", "refused"]);
    assert.ok(tab.complaints.length >= 3 && tab.complaints.every((text) => /Content Security Policy/.test(text)), tab.complaints.join("\n"));
    await tab.close();
});

for (const width of [390, 1280]) {
    onPage(`${width} px, light and dark: axe finds nothing, nothing is too wide, keys suffice`, async (tab) => {
        await answers(tab, [shipped("q-10.dbc"), lie("less-deep-10.dbc")]);
        await tab.getByLabel("this claim:").focus();
        await tab.keyboard.press("Space");
        await tab.locator("#count").fill("4");
        await tab.keyboard.press("Enter");
        await ended(tab, 2);
        await tab.evaluate(axe);
        for (const colorScheme of ["light", "dark"]) {
            await tab.emulateMedia({ colorScheme });
            const found = await tab.evaluate(async () => (await window.axe.run(document)).violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(" | ")}`));
            assert.deepEqual(found, [], colorScheme);
            assert.ok((await tab.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0, colorScheme);
        }
    }, { viewport: { width, height: 844 } });
}

test("the pages are as large as docs/4-verifying.md says: at most 535 kB with gzip, and 700 kB in a page", () => {
    const said = readFileSync(join(root, "docs", "4-verifying.md"), "utf8");
    const [whole, packed, added] = /one file of (\d+) kB \((\d+) kB with gzip\)[^]*The verifier adds (\d+) kB/.exec(said).slice(1).map((kB) => 1000 * kB);
    const near = (bytes, told) => assert.ok(Math.abs(bytes - told) < 3000, `${bytes} bytes, said ${told}`);
    const bytes = readFileSync(page);
    const gzipped = gzipSync(bytes, { level: 9 }).length;
    near(bytes.length, whole);
    near(gzipped, packed);
    assert.ok(gzipped <= 535_000, String(gzipped));
    const sizes = [[], ["--no-verifier"]].map((options) => {
        dumbbell("report", shipped("q-10.dbc"), ...options, "--out", place("size.html"));
        return readFileSync(place("size.html")).length;
    });
    near(sizes[0] - sizes[1], added);
    assert.ok(sizes[0] - sizes[1] <= 700_000, String(sizes));
});

test("a page of dumbbell report verifies what it shows", async () => {
    const out = place("report.html");
    dumbbell("report", shipped("stairs-1-100.dbc"), shipped("full-100.dbc.gz"), "--out", out);
    const tab = await open(browser, out);
    const texts = await (await ended(tab, 2)).allTextContents();
    assert.match(texts[0], /^Verified here, in your browser, in .* demanded-ratio=1\/1:100\/1 max=10 min=2/);
    assert.match(texts[1], /^Verified here, in your browser, in .* demanded-ratio=100\/1 exactly=10|^Verified here, in your browser, in .* exactly=10/);
    assert.match(await tab.textContent("main"), /It contains the verifier, and runs it here, on each file/);
    await tab.evaluate(axe);
    assert.deepEqual(await tab.evaluate(async () => (await window.axe.run(document.querySelector(".verify"))).violations.map(({ id }) => id)), []);
    quiet(tab, out);
    await tab.close();
    dumbbell("report", shipped("stairs-1-100.dbc"), "--no-verifier", "--out", out);
    const without = await open(browser, out);
    assert.match(await without.textContent("main"), /It has not been verified here/);
    quiet(without, out);
    await without.close();
});
