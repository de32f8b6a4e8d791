// Accessibility, as far as a program can tell it: axe finds nothing, in any section, wide and narrow, light and dark.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { stage } from "./browser.mjs";
import { root } from "./program.mjs";

const axe = readFileSync(join(root, "web", "node_modules", "axe-core", "axe.min.js"), "utf8");
const { files, onPage } = await stage();
const { stairs, ten, full, rod, starts, incoming } = files; // one of each kind of page

const findings = (page) =>
    page.evaluate(async () => {
        const { violations } = await window.axe.run(document);
        return violations.map(({ id, impact, nodes }) => `${impact}: ${id}: ${nodes.slice(0, 3).map((node) => node.html.slice(0, 120)).join(" | ")}`);
    });

onPage("axe finds nothing, narrow and wide, light and dark, with everything unfolded", [stairs, ten, full, rod, starts, incoming], async (page) => {
    await page.evaluate(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
    await page.evaluate(axe);
    for (const width of [400, 1280]) {
        await page.setViewportSize({ width, height: 900 });
        for (const colorScheme of ["light", "dark"]) {
            await page.emulateMedia({ colorScheme });
            assert.deepEqual(await findings(page), [], `${width} px, ${colorScheme}`);
        }
    }
});

onPage("axe does find what is wrong", ten, async (page) => {
    await page.evaluate(() => {
        document.querySelector("#file-1 .plane-buttons button:last-child").setAttribute("aria-label", "Show everything");
        document.querySelector("#file-1 thead th").textContent = "";
    });
    await page.evaluate(axe);
    const found = (await findings(page)).join("\n");
    assert.match(found, /serious: label-content-name-mismatch/);
    assert.match(found, /empty-table-header/);
});

onPage("what is computed is read out: results are live, and a player is silent while it plays", [stairs, ten], async (page) => {
    const lives = await page.evaluate(() => [...document.querySelectorAll("output")].map((o) => o.getAttribute("aria-live")));
    assert.ok(lives.length > 4 && lives.every((live) => live === "polite"), lives.join());
    const player = page.locator("#file-2 .player");
    await player.getByRole("button", { name: "Play" }).click();
    assert.equal(await player.locator("output").getAttribute("aria-live"), "off");
    await player.getByRole("button", { name: "Pause" }).click();
    assert.equal(await player.locator("output").getAttribute("aria-live"), "polite");
});
