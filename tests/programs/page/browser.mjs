// A page in headless Chromium: what it complains about, what it asks for, what it has drawn.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { join } from "node:path";
import test, { after } from "node:test";
import { certificates, report, root, scratch } from "./program.mjs";

const { chromium } = createRequire(join(root, "web", "package.json"))("playwright-core");

const patience = 600_000; // ms: more than anything takes on a busy machine

export const launch = () =>
    chromium.launch({ executablePath: process.env.DUMBBELL_CHROMIUM, timeout: patience, args: ["--no-sandbox", "--disable-gpu", "--disable-background-networking"] });

/// Opens a file, and stops what moves by itself unless `moves`; options as for a new page. `page.complaints` are errors and warnings, `page.requests` what it asked for.
export async function open(browser, file, { moves = false, ...options } = {}) {
    const page = await browser.newPage({ viewport: { width: 1200, height: 900 }, colorScheme: "light", ...options });
    page.setDefaultTimeout(patience);
    page.complaints = [];
    page.requests = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && page.complaints.push(message.text()));
    page.on("pageerror", (error) => page.complaints.push(String(error.stack)));
    const fails = new Promise((resolve) => page.once("pageerror", resolve));
    page.on("request", (request) => request.url().startsWith("data:") || page.requests.push(request.url()));
    await page.goto(`file://${file}`);
    const error = await Promise.race([page.waitForFunction(() => document.documentElement.dataset.drawn).then(() => null, (error) => error), fails]);
    if (error) {
        throw new Error(`the page was not drawn: ${[...page.complaints, error.message].join("; ")}`);
    }
    if (!moves) {
        await page.evaluate(() => {
            const buttons = [...document.querySelectorAll(".transport button")];
            if (buttons.some((button) => button.textContent === "Pause")) {
                buttons.find((button) => button.textContent === "Start").click();
                buttons.find((button) => button.textContent === "Pause").click();
            }
        });
    }
    return page;
}

/// What tests of pages have in common: a browser, certificates of every kind, and onPage(name, files, run, options), a test that opens the
/// report on these files, which must not complain: run(page, its file).
export async function stage() {
    const place = scratch();
    const files = certificates(place);
    const browser = await launch();
    after(() => browser.close());
    const onPage = (name, of, run, options) => test(name, async () => {
        const file = report(place("page.html"), ...[of].flat());
        const page = await open(browser, file, options);
        await run(page, file);
        assert.deepEqual(page.complaints, []);
        await page.close();
    });
    return { browser, files, onPage, place };
}

/// After a gesture a slow picture is drawn anew a moment later: by a timer of the page, after which this one comes.
export const settled = (page) => page.evaluate(() => new Promise((done) => setTimeout(done, 100)));

/// The pixels of a canvas as {width, height, scale, at(x, y)} in CSS pixels: at gives "r,g,b", "" where nothing is drawn.
export async function pixels(locator) {
    const { data, width, height, scale } = await locator.evaluate((canvas) => {
        // From a copy: the page's own canvas is not made to be read.
        const copy = document.createElement("canvas");
        [copy.width, copy.height] = [canvas.width, canvas.height];
        const context = copy.getContext("2d", { willReadFrequently: true });
        context.drawImage(canvas, 0, 0);
        const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
        let text = "";
        for (let i = 0; i < data.length; i += 8192) {
            text += String.fromCharCode(...data.subarray(i, i + 8192));
        }
        return { data: btoa(text), width: canvas.width, height: canvas.height, scale: canvas.width / canvas.clientWidth };
    });
    const bytes = Buffer.from(data, "base64");
    const at = (x, y) => {
        const i = 4 * (Math.round(y * scale) * width + Math.round(x * scale));
        return bytes[i + 3] === 0 ? "" : `${bytes[i]},${bytes[i + 1]},${bytes[i + 2]}`;
    };
    return { bytes, width: width / scale, height: height / scale, at };
}

/// Where a place of a plane's picture is on its canvas.
export async function placeOf(locator, x, y) {
    const { frame, window: w } = await locator.evaluate((canvas) => ({ frame: JSON.parse(canvas.dataset.frame), window: JSON.parse(canvas.dataset.window) }));
    return [
        frame.x + ((x - w.x0) / (w.x1 - w.x0)) * frame.width,
        frame.y + frame.height - ((y - w.y0) / (w.y1 - w.y0)) * frame.height,
    ];
}

/// A colour of the style sheet as "r,g,b".
export const colour = (page, name) =>
    page.evaluate((variable) => {
        const probe = document.createElement("i");
        probe.style.color = `var(${variable})`;
        document.body.append(probe);
        const text = getComputedStyle(probe).color;
        probe.remove();
        return text.match(/\d+/g).slice(0, 3).join(",");
    }, name);

/// The share of the canvas's pixels that have something other than nothing or the most frequent colour.
export function inkShare({ bytes }) {
    const counts = new Map();
    for (let i = 0; i < bytes.length; i += 4) {
        const key = bytes.readUInt32LE(i);
        counts.set(key, (counts.get(key) ?? 0) + 1);
    }
    return 1 - Math.max(...counts.values()) / (bytes.length / 4);
}
