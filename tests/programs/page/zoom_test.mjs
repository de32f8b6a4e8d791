import assert from "node:assert/strict";
import { colour, pixels, placeOf, settled, stage } from "./browser.mjs";
import { long } from "./program.mjs";

const { files, onPage } = await stage();

const windowOf = (canvas) => canvas.evaluate((c) => JSON.parse(c.dataset.window));
const span = ({ x0, x1 }) => x1 - x0;

onPage("buttons, keys, double click and wheel zoom; 0 and Reset show everything again", files.full, async (page) => {
    const figure = page.locator("#file-1 .map .plane").first();
    const canvas = figure.locator("canvas");
    const home = await windowOf(canvas);
    const click = async (name) => {
        await figure.getByRole("button", { name }).click();
        await settled(page);
        return windowOf(canvas);
    };
    const press = async (key) => {
        await canvas.press(key);
        await settled(page);
        return windowOf(canvas);
    };
    assert.ok(Math.abs(span(await click("Zoom in")) / span(home) - 0.5) < 1e-9);
    assert.ok(Math.abs(span(await click("Zoom out")) / span(home) - 1) < 1e-9);
    const moved = await press("ArrowRight");
    assert.ok(moved.x0 > home.x0 && Math.abs(span(moved) - span(home)) < 1e-9);
    assert.ok((await press("ArrowUp")).y0 > home.y0);
    assert.ok(span(await press("+")) < span(home));
    assert.deepEqual(await press("0"), home);
    await canvas.dblclick({ position: { x: 300, y: 200 } });
    await settled(page);
    assert.ok(span(await windowOf(canvas)) < 0.4 * span(home));
    assert.deepEqual(await click("Reset"), home);
    await canvas.focus();
    await canvas.hover({ position: { x: 300, y: 200 } });
    await page.mouse.wheel(0, -400);
    await settled(page);
    assert.ok(span(await windowOf(canvas)) < 0.7 * span(home));
});

onPage("the wheel scrolls the page where the picture does not have the focus", files.full, async (page) => {
    const canvas = page.locator("#file-1 .map canvas").first();
    const home = await windowOf(canvas);
    await canvas.hover({ position: { x: 300, y: 200 } });
    await page.mouse.wheel(0, 300);
    await page.waitForFunction(() => scrollY > 0);
    assert.deepEqual(await windowOf(canvas), home);
});

onPage("dragging moves the picture with the pointer", files.full, async (page) => {
    const canvas = page.locator("#file-1 .map canvas").first();
    await canvas.scrollIntoViewIfNeeded();
    const box = await canvas.boundingBox();
    const home = await windowOf(canvas);
    const before = await placeOf(canvas, 1, 1);
    await page.mouse.move(box.x + 400, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 460, box.y + 170, { steps: 6 });
    await page.mouse.up();
    await settled(page);
    const after = await placeOf(canvas, 1, 1);
    assert.ok(Math.abs(span(await windowOf(canvas)) - span(home)) < 1e-9);
    assert.ok(Math.abs(after[0] - before[0] - 60) < 12 && Math.abs(after[1] - before[1] + 30) < 8, `${before} ${after}`);
});

onPage("every step of a staircase can be chosen, and its gap is seen in its true width", long, async (page) => {
    const choice = page.locator("#file-1 .map .controls select").first();
    const canvas = page.locator("#file-1 .map canvas").first();
    const gap = await colour(page, "--gap");
    const count = await choice.locator("option").count();
    assert.equal(count, 2 + 885); // the whole range, and the typed ratio
    for (const i of [0, 1, 2, 100, 500, 884]) {
        await choice.selectOption(String(i));
        await settled(page);
        const { x0, x1 } = await windowOf(canvas);
        const picture = await pixels(canvas);
        const { frame } = await canvas.evaluate((c) => ({ frame: JSON.parse(c.dataset.frame) }));
        const row = await canvas.evaluate((c) => JSON.parse(c.dataset.window)).then((w) => (w.y0 + w.y1) / 2);
        const levels = [];
        for (let y = Math.ceil(frame.y); y < frame.y + frame.height; ++y) {
            let width = 0;
            for (let x = Math.ceil(frame.x); x < frame.x + frame.width; ++x) {
                width += picture.at(x, y) === gap ? 1 : 0;
            }
            levels.push(width);
        }
        const width = Math.max(...levels) / frame.width;
        assert.ok(Math.abs(width - 1 / 9) < 0.02, `step ${i}: ${width} of the window ${x1 - x0}, ${row}`);
        const told = await page.locator("#file-1 .map .readout").first().textContent();
        assert.match(told, /is \d+ or \d+ \(a gap around the step\)/);
    }
    await choice.selectOption("");
    await settled(page);
    assert.ok(span(await windowOf(canvas)) > 5.9);
});

onPage("a gap 40 orders of magnitude narrower than its ratio is shown, too", files.fine, async (page) => {
    await page.locator("#file-1 .map .controls select").first().selectOption("0");
    await settled(page);
    const canvas = page.locator("#file-1 .map canvas").first();
    const width = span(await windowOf(canvas));
    assert.ok(width > 0 && width < 1e-38, String(width));
    const picture = await pixels(canvas);
    const [x, y] = await placeOf(canvas, (await windowOf(canvas)).x0 + width / 2, 3.5);
    assert.equal(picture.at(x, y), await colour(page, "--gap"));
});

onPage("a typed ratio is gone to", files.stairs, async (page) => {
    await page.getByLabel("around q =", { exact: true }).fill("50");
    await page.getByRole("button", { name: "Go" }).click();
    await settled(page);
    const { x0, x1 } = await windowOf(page.locator("#file-1 .map canvas").first());
    assert.ok(x0 < Math.log10(50) && Math.log10(50) < x1 && x1 - x0 < 0.1);
    const choice = page.getByLabel("Show", { exact: true });
    const told = () => page.locator("#file-1 .map .readout").first().textContent();
    assert.match(await told(), /N\(q\) = 8/);
    assert.equal(await choice.inputValue(), "around");
    await choice.selectOption(""); // back, by the choice that no longer shows where one is
    await settled(page);
    assert.ok(span(await windowOf(page.locator("#file-1 .map canvas").first())) > 1.9);
    const go = async (text) => {
        await page.getByLabel("around q =", { exact: true }).fill(text);
        await page.getByRole("button", { name: "Go" }).click();
        return told();
    };
    assert.match(await go("abc"), /\u201cabc\u201d is not a mass ratio: write a number/);
    assert.equal(await choice.inputValue(), "");
    assert.match(await go("1000"), /Nothing is claimed about q = 1000/);
    assert.match(await go("1/50"), /N\(q\) = 8/); // the masses swapped
});

onPage("the axes of a box of initial conditions can be turned, and cut", files.solid, async (page) => {
    const canvas = page.locator("#file-1 .map canvas").first();
    const before = await pixels(canvas);
    await page.getByLabel("Across").selectOption({ label: "y" });
    await settled(page);
    const turned = await pixels(canvas);
    assert.notDeepEqual(before.bytes, turned.bytes);
    const slider = page.getByLabel("cut at phi");
    await slider.focus();
    await slider.press("End");
    await settled(page);
    assert.notDeepEqual((await pixels(canvas)).bytes, turned.bytes);
});
