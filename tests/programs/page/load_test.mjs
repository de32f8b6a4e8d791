import assert from "node:assert/strict";
import { copyFileSync, readFileSync } from "node:fs";
import { stage } from "./browser.mjs";
import { dumbbell, long } from "./program.mjs";

const { files, onPage, place } = await stage();
const everything = Object.values(files);

const overflow = () => document.documentElement.scrollWidth - document.documentElement.clientWidth;
const beyond = () => [...document.querySelectorAll("main *")]
    .filter((e) => !e.closest(".scroll, .command, option") && e.getBoundingClientRect().right > innerWidth + 0.5).map((e) => e.outerHTML.slice(0, 90));

onPage("every kind of certificate, at three widths, light and dark: no error, no request, no overflow", everything, async (page, all) => {
    for (const unfolded of [false, true]) {
        await page.evaluate((open) => open && document.querySelectorAll("details").forEach((details) => (details.open = true)), unfolded);
        for (const width of [400, 800, 1600]) {
            await page.setViewportSize({ width, height: 900 });
            for (const colorScheme of ["light", "dark"]) {
                await page.emulateMedia({ colorScheme });
                const where = `${width} px, ${colorScheme}${unfolded ? ", unfolded" : ""}`;
                assert.ok((await page.evaluate(overflow)) <= 0, where);
                assert.deepEqual(unfolded ? [] : await page.evaluate(beyond), [], where);
            }
        }
    }
    assert.deepEqual(page.requests, [`file://${all}`]);
});

for (const [name, file] of Object.entries({ ...files, long })) {
    onPage(`${name} alone: no error, its name, its checksum, the command that verifies it`, file, async (page) => {
        const text = await page.textContent("main");
        assert.match(text, /dumbbell verify --/);
        assert.match(text, /It has not been verified here/);
        assert.doesNotMatch(text, /false|undefined|NaN/);
        assert.match(text, /[0-9a-f]{64}/);
        assert.ok(text.includes(file.split("/").at(-1)));
    });
}

// N is beyond 2^63; a range whose pieces differ by one beyond 2^53.
const far = ["1.2e38", "1.0345e32:1.034500000000000095e32"];

for (const ratio of far) {
    const file = place(`far-${ratio.replace(":", "-")}.dbc`);
    dumbbell("certify", ratio, "--out", file, "--quiet");
    onPage(`the counts of q = ${ratio} are the certificate's, to the last digit`, file, async (page) => {
        const lines = readFileSync(file, "utf8").split("\n");
        const counts = lines.flatMap((line) => /^(?:upper|lower) (\d+)$/.exec(line)?.[1] ?? []);
        assert.ok(counts.length >= 2 && counts.every((n) => BigInt(n) > 2n ** 53n), String(counts));
        const text = await page.textContent("main");
        assert.deepEqual(counts.filter((n) => !text.includes(n)), []);
        const pieces = await page.locator("table").filter({ hasText: "claimed" }).textContent();
        for (const n of counts) {
            assert.match(pieces, new RegExp(`N = ([0-9]+ or )?${n}`));
        }
        const [, forward, backward] = /^witness \S+ \S+ \S+ (\d+) (\d+)$/m.exec(lines.join("\n"));
        assert.ok(text.includes(`An orbit with ${(1n + BigInt(forward) + BigInt(backward)).toLocaleString("en")} collisions`) || counts.length > 2);
    });
}

onPage("what is claimed is said, with its lemmas", [files.ten, files.stairs, files.full, files.plain, files.starts, files.incoming, files.coin, files.rod], async (page) => {
    const text = await page.textContent("main");
    for (const words of [
        "N(q) = 4: with mass ratio q = 10 no trajectory hits the floor more than 4 times, and some trajectory hits it 4 times",
        "N(q) goes from 2 to 10 as q goes from 1 to 100",
        "known at every q but in 8 narrow gaps around its steps, where it is one of two neighbouring numbers",
        "The heavy mass hits the floor at most once.",
        "Why so few boxes?",
        "collisions, section plain",
        "Plain interval evaluation, without monotonicity",
        "Nothing is said about other starts",
        "Every trajectory that comes in from above at mass ratio q = 10 and meets no corner has between 1 and 4 collisions",
        "Monotone step: a lower, flatter ray never has fewer collisions left",
        "N(Q) = 4: with Q = (d1/k)\u00b2 = 4 no trajectory of a body with \u03c1 = d2/d1 = 1 (in a plane, as long as it meets no corner) hits the floor more than 4 times",
        "Motions close to the corner have 4 collisions, for Q = 4.",
        "dumbbell verify --coin --exactly 4",
        "Witness: a body\u2019s orbit that has so many collisions",
        "Not rigorous: computed by this page in double precision",
    ]) {
        assert.ok(text.includes(words), words);
    }
    assert.equal(text.split("The heavy mass hits the floor at most once.").length, 3); // of full and plain, not of bodies
});

for (const [of, title] of [[files.ten, "q-10.dbc"], [everything, `${everything.length} files`]]) {
    onPage(`the page's title tells its file, or counts them: ${title}`, of, async (page) => assert.equal(await page.title(), `dumbbell: ${title}`));
}

const odd = place("<img src=x onerror=alert(1)>.dbc");
copyFileSync(files.ten, odd);
onPage("a file's name is text, whatever it is", odd, async (page) => {
    assert.equal(await page.locator("img").count(), 0);
    assert.ok((await page.textContent("main")).includes("<img src=x onerror=alert(1)>.dbc"));
});

onPage("on paper everything is open and white, and afterwards as it was", [files.stairs, files.full], async (page) => {
    const state = () => page.evaluate(() => [document.querySelectorAll("details:not([open])").length, getComputedStyle(document.body).backgroundColor]);
    const before = await state();
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    assert.deepEqual(await state(), [0, "rgb(255, 255, 255)"]);
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    assert.deepEqual(await state(), before);
    await page.emulateMedia({ media: "print" });
    const printed = await page.evaluate(() => ({
        swatches: [...document.querySelectorAll(".swatch i")].map((e) => getComputedStyle(e).printColorAdjust),
        keys: [...document.querySelectorAll(".key")].map((e) => getComputedStyle(e, "::before").printColorAdjust),
        breaks: [...document.querySelectorAll("section")].map((e) => getComputedStyle(e).breakBefore),
        headings: [...document.querySelectorAll("h2, h3, .tables > summary")].map((e) => getComputedStyle(e).breakAfter),
    }));
    // Colours that stand for something are printed, the first file begins below the title, no heading is left behind.
    assert.ok(printed.swatches.length > 2 && printed.swatches.concat(printed.keys).every((adjust) => adjust === "exact"), printed.swatches.join());
    assert.deepEqual([...new Set(printed.breaks.slice(1))], ["page"]);
    assert.notEqual(printed.breaks[0], "page");
    assert.ok(printed.headings.every((value) => value === "avoid"), printed.headings.join());
    await page.emulateMedia({ media: null });
    const pdf = await page.pdf({ format: "A4" });
    assert.ok(pdf.length > 20000);
}, { colorScheme: "dark" });
