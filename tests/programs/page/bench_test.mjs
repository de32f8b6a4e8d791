// How long a page with 10^5 boxes takes: printed, with what it is on; no limit is checked, since the machine may be busy.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { loadavg, cpus } from "node:os";
import { statSync } from "node:fs";
import { launch, open } from "./browser.mjs";
import { dumbbell, report, scratch } from "./program.mjs";

const place = scratch();
const browser = await launch();
after(() => browser.close());

test("the first drawing with 10^5 boxes, and the drawing of its boxes alone", async () => {
    const certificate = place("plain.dbc.gz");
    dumbbell("certify", "100", "--section", "plain", "--out", certificate);
    const page = place("page.html");
    dumbbell("report", certificate, "--max-boxes", 100000, "--out", page);
    const times = [];
    const redraws = [];
    for (let i = 0; i < 5; ++i) {
        const opened = await open(browser, page, { viewport: { width: 1600, height: 900 } });
        times.push(await opened.evaluate(() => Number(document.documentElement.dataset.drawn)));
        assert.match(await opened.textContent("main"), /boxes of the file are drawn as 99,\d\d\d|drawn as 100,000/);
        redraws.push(Number(await opened.locator("#file-1 .plane canvas").first().getAttribute("data-ms")));
        await opened.close();
    }
    const middle = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];
    console.log(`page of ${(statSync(page).size / 1e6).toFixed(1)} MB, 100,000 boxes: first drawing after ${middle(times)} ms (${times.join(", ")}); the picture of the boxes alone ${middle(redraws)} ms, while it is moved less`);
    console.log(`load ${loadavg()[0].toFixed(1)} on ${cpus().length} cores, ${cpus()[0].model}`);
});
