// dumbbell.html, and a page of dumbbell report that contains the verifier, in headless Chromium, from disk.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
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

/// The page, once its first question, or `count` files, are proved and verified: what the badges say.
async function ended(tab, count = 1) {
    await tab.waitForFunction((n) => document.querySelectorAll(".outcome[data-outcome]").length === n, count);
    return tab.locator(".badge").allTextContents();
}
const quiet = (tab, file = page) => {
    assert.deepEqual(tab.complaints, []);
    assert.deepEqual(tab.requests.filter((url) => !url.startsWith("blob:")), [`file://${file}`]);
};
const onPage = (name, run, options) => test(name, async () => {
    const tab = await open(browser, page, options);
    await ended(tab);
    await run(tab);
    quiet(tab);
    await tab.close();
});
const thing = (tab) => tab.getByLabel("How often can it hit the floor:");
const ratio = (tab) => tab.getByLabel(/^mass ratio, or/);
const said = (tab) => tab.locator(".told").textContent();

/// Asks, and waits for the claim to say so, and for its badge.
async function ask(tab, text, expected) {
    if (text !== null) {
        await ratio(tab).fill(text);
    }
    await tab.getByRole("button", { name: "Prove it" }).click();
    await tab.waitForFunction((start) => document.querySelector(".claim")?.textContent.startsWith(start) && document.querySelector(".outcome[data-outcome]"), expected);
    assert.deepEqual(await tab.locator(".badge").allTextContents(), ["verified here"]);
}
async function take(tab, file, state) {
    await tab.locator("#files").setInputFiles(file);
    await tab.waitForFunction(([name, start]) => document.querySelector("main").textContent.includes(name) && document.querySelector(".outcome[data-outcome] .state")?.textContent.startsWith(start), [basename(file), state]);
}

onPage("a question is proved, verified with its claim, and its longest orbit plays", async (tab) => {
    for (const [text, start] of [["10", "N(q) = 4: with mass ratio q = 10 no trajectory hits"], ["1e6", "N(q) = 887"], ["1:100", "N(q) goes from 2 to 10 as q goes from 1 to 100"], ["4/3", "N(q) = 3"], [" 1 / 7", "N(q) = 4: with mass ratio q = 7"]]) {
        await ask(tab, text, start);
    }
    await ask(tab, "100", "N(q) = 10");
    await ask(tab, "1:100", "N(q) goes from 2");
    assert.match(await tab.locator(".outcome").textContent(), /demanded-ratio=1\/1:100\/1 max=10 min=2/);
    assert.match(await tab.locator("main").textContent(), /It retraces itself/);
    assert.equal(await tab.locator("#file-1 .player").getByRole("button", { name: "Pause" }).count(), 1);
}, { moves: true });

onPage("bodies have contacts, and look like what they are", async (tab) => {
    for (const [id, n, shape] of [["coin", 4, "disc"], ["ring", 3, "ring"], ["uniform", 3, "none"]]) {
        await thing(tab).selectOption(id);
        await ask(tab, null, `N(Q) = ${n}`);
        assert.equal(await tab.locator("#file-1 .dumbbell ellipse").first().getAttribute("class"), shape);
        assert.match(await tab.locator("#file-1 .floor").textContent(), /^contact 1contact 2$/);
        assert.doesNotMatch(await tab.locator("#file-1 .player").textContent(), /mass/);
    }
    await thing(tab).selectOption("body");
    await tab.getByLabel(/^Q =/).fill("3:4");
    await ask(tab, null, "N(Q) is 3 as Q goes from 3 to 4");
    await thing(tab).selectOption("rod");
    await ask(tab, "10", "N(Q) = 5");
});

onPage("a body is pointed at in the plane of all: it is proved, verified, and moves beside the picture", async (tab) => {
    await thing(tab).selectOption("body");
    const plane = tab.getByRole("slider", { name: /^The plane of bodies/ });
    const proved = async (place, claim) => {
        await tab.waitForFunction(([text, start]) => document.querySelector(".bodies").ariaValueText === text && document.querySelector(".pair .claim")?.textContent.startsWith(start) && document.querySelector(".outcome[data-outcome]"), [place, claim]);
        assert.deepEqual(await tab.locator(".pair .badge").allTextContents(), ["verified here"]);
    };
    const click = async ([x, y]) => {
        const scale = await plane.evaluate((field) => field.clientWidth / field.shadowRoot.querySelector("svg").viewBox.baseVal.width);
        await plane.click({ position: { x: x * scale, y: y * scale } });
    };
    const coin = await plane.evaluate((field) => {
        const { cx, cy } = [...field.shadowRoot.querySelectorAll("circle.body")].find((circle) => circle.nextElementSibling.textContent === "coin");
        return [cx.baseVal.value, cy.baseVal.value];
    });
    await click(coin);
    await proved("\u03c1 = 1, Q = 4", "N(Q) = 4");
    assert.equal(await tab.locator(".pair .dumbbell ellipse").first().getAttribute("class"), "disc");
    await tab.keyboard.press("ArrowDown");
    await proved("\u03c1 = 1, Q = 3.82", "N(Q) = 4");
    await click([80, 580]); // mass beyond the contacts
    await tab.waitForFunction(() => document.querySelector(".pair .claim")?.textContent.startsWith("N(Q) = 3"));
    await thing(tab).selectOption("coin");
    assert.equal(await tab.locator("#file-1 .claim").count(), 1);
});

onPage("what the page does not decide, or does not understand, it says, with the command that does", async (tab) => {
    for (const [text, told, command] of [["1e10", /up to 10\^9/, "dumbbell certify 10000000000"], ["1:1e4", /up to 1:1000/, "dumbbell certify 1:10000 --gap 1e-6"], ["ten", /'ten' is not a number/, null], ["1e400", /beyond 10\^100/, null]]) {
        await ratio(tab).fill(text);
        await ratio(tab).press("Enter");
        await tab.waitForFunction((source) => new RegExp(source).test(document.querySelector(".told").textContent), told.source);
        assert.deepEqual(await tab.locator(".ask .command code").allTextContents(), command ? [command] : []);
    }
    await ask(tab, "3", "N(q) = 3");
    assert.equal(await said(tab), "");
});

onPage("files of every kind are verified and shown; one of the law is verified", async (tab) => {
    for (const name of ["stairs-1-1e4.dbc.gz", "coin.dbc", "full-1000.dbc.gz"]) {
        await take(tab, shipped(name), "Verified here");
        assert.equal(await tab.locator("#file-1 canvas").count() > 0, true, name);
    }
    await tab.locator("#files").setInputFiles(shipped("law.dbc.gz"));
    await tab.waitForFunction(() => /Verifying: /.test(document.querySelector(".state")?.textContent));
    await tab.locator(".outcome").getByRole("button", { name: "Stop" }).click();
    await ended(tab);
    assert.equal(await tab.locator(".state").textContent(), "Stopped");
    await ask(tab, "10", "N(q) = 4"); // in another worker
});

onPage("a claim of one's own: a file that proves less is rejected", async (tab) => {
    await take(tab, shipped("stairs-1-100.dbc"), "Verified here");
    for (const [claim, verdict, badge] of [["--ratio 5:30 --max 6", "Verified here", "verified here"], ["--ratio 1:100 --max 9", "Rejected", "not verified: rejected"], ["--ratio ten --max 4", "The claim cannot be read", "not verified: the claim cannot be read"], ["--gap 1e-9", "Rejected", "not verified: rejected"]]) {
        await tab.getByLabel("Claim", { exact: true }).fill(claim);
        await tab.getByLabel("Claim", { exact: true }).press("Enter");
        const [mark] = await ended(tab);
        assert.equal(mark, badge);
        assert.ok((await tab.locator(".state").textContent()).startsWith(verdict), claim);
    }
});

onPage("a file is dropped anywhere on the page", async (tab) => {
    const data = await tab.evaluateHandle((text) => {
        const dropped = new DataTransfer();
        dropped.items.add(new File([text], "dropped.dbc"));
        return dropped;
    }, readFileSync(shipped("q-100.dbc"), "utf8"));
    await tab.dispatchEvent("body", "drop", { dataTransfer: data });
    await tab.waitForFunction(() => document.querySelector(".claim").textContent.startsWith("N(q) = 10"));
    assert.deepEqual(await ended(tab), ["verified here"]);
});

onPage("hostile files get an answer or a limit, and the page stays alive", async (tab) => {
    const text = readFileSync(shipped("stairs-1-100.dbc"));
    for (const [file, state] of [
        [lie("less-deep-10.dbc"), "Rejected"],
        [lie("tree-void.dbc"), "Rejected"],
        [given("empty.dbc", ""), "Rejected"],
        [given("noise.dbc", Buffer.from(Array.from({ length: 100_000 }, (_, i) => (i * i * 7919) % 251))), "Rejected"],
        [given("cut.dbc.gz", gzipSync(text).subarray(0, 400)), "Rejected"],
        [given("bomb.dbc.gz", gzipSync(Buffer.alloc(200_000_000, "split x\n"))), "Rejected"],
        [given("line.dbc", Buffer.alloc(5_000_000, "9")), "Rejected"],
        [given("<img src=x onerror=alert(1)>.dbc", text), "Verified"],
    ]) {
        await take(tab, file, state);
    }
    assert.equal(await tab.locator("img").count(), 0);
});

test("a proof is a short link; a damaged one says so in a line", async () => {
    const context = await browser.newContext();
    const tab = await context.newPage();
    await tab.goto(`file://${page}`);
    await tab.evaluate(() => (navigator.clipboard.writeText = async (text) => (window.copied = text)));
    await ask(tab, "1e6", "N(q) = 887");
    await tab.getByRole("button", { name: "Copy link" }).click();
    const link = await tab.evaluate(() => window.copied);
    const proof = link.slice(`file://${page}`.length);
    assert.ok(proof.startsWith("#proof=") && proof.length < 450, proof);
    const other = await context.newPage();
    await other.goto(link);
    assert.deepEqual(await ended(other), ["verified here"]);
    assert.match(await other.locator(".claim").first().textContent(), /^N\(q\) = 887: with mass ratio q = 1000000/);
    for (const damaged of [proof.slice(0, -40), `${proof.slice(0, 60)}A${proof.slice(61)}`, "#proof=", "#proof=%%", "#proof=ssssss"]) {
        await other.evaluate((hash) => (location.hash = hash), damaged);
        await other.waitForFunction(() => document.querySelector(".told").textContent.startsWith("The link is damaged"), null, { timeout: 20_000 });
        await other.evaluate(() => (location.hash = "#own"));
        await other.evaluate(() => (document.querySelector(".told").textContent = ""));
    }
    await context.close();
});

test("a browser that lacks something is told what", async () => {
    const tab = await browser.newPage();
    await tab.addInitScript(() => delete globalThis.DecompressionStream);
    await tab.goto(`file://${page}`);
    await tab.waitForFunction(() => document.documentElement.dataset.drawn);
    assert.match(await said(tab), /^This browser lacks .*: DecompressionStream\. Firefox 113/);
    await tab.close();
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
        await ratio(tab).focus();
        await tab.keyboard.press("Control+A");
        await tab.keyboard.type("1:100");
        await tab.keyboard.press("Enter");
        await tab.waitForFunction(() => document.querySelector(".claim").textContent.startsWith("N(q) goes") && document.querySelector(".outcome[data-outcome]"));
        await thing(tab).selectOption("body"); // the plane, too
        await tab.evaluate(axe);
        for (const colorScheme of ["light", "dark"]) {
            await tab.emulateMedia({ colorScheme });
            const found = await tab.evaluate(async () => (await window.axe.run(document)).violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(" | ")}`));
            assert.deepEqual(found, [], colorScheme);
            assert.ok((await tab.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0, colorScheme);
        }
    }, { viewport: { width, height: 844 } });
}

test("the pages are as large as docs/4-verifying.md says", () => {
    const said = readFileSync(join(root, "docs", "4-verifying.md"), "utf8");
    const [whole, packed, added] = /one file of (\d+) kB \((\d+) kB with gzip\)[^]*The verifier adds (\d+) kB/.exec(said).slice(1).map((kB) => 1000 * kB);
    const near = (bytes, told) => assert.ok(Math.abs(bytes - told) < 3000, `${bytes} bytes, said ${told}`);
    const bytes = readFileSync(page);
    const gzipped = gzipSync(bytes, { level: 9 }).length;
    near(bytes.length, whole);
    near(gzipped, packed);
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
    const texts = await ended(tab, 2).then(() => tab.locator(".outcome").allTextContents());
    assert.match(texts[0], /^Verified here, in your browser, in .* demanded-ratio=1\/1:100\/1 max=10 min=2/);
    assert.match(texts[1], /^Verified here, in your browser, in .* demanded-ratio=100\/1 exactly=10|^Verified here, in your browser, in .* exactly=10/);
    assert.deepEqual(await tab.locator(".badge").allTextContents(), ["verified here", "verified here"]);
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
