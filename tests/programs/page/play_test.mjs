import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test from "node:test";
import { open, pixels, placeOf, stage } from "./browser.mjs";
import { paperBound } from "../../../web/src/paper.js";
import { report } from "./program.mjs";

const { browser, files, onPage, place } = await stage();

const player = (page, section = "#file-1") => {
    const of = page.locator(`${section} .player`);
    return {
        of,
        status: () => of.locator(".readout").textContent(),
        button: (name) => of.getByRole("button", { name }),
        position: () => of.locator(".scrub").inputValue().then(Number),
        dumbbell: () => of.locator(".dumbbell svg").innerHTML(),
        point: () => pixels(of.locator(".plane canvas")),
    };
};

onPage("step by step through all collisions, and back", files.ten, async (page) => {
    const { status, button } = player(page);
    assert.match(await status(), /^Before the first of 4 collisions/);
    const masses = [];
    for (let i = 1; i <= 4; ++i) {
        await button("Step \u25b6").click();
        const told = await status();
        assert.match(told, new RegExp(`^Collision ${i} of 4, of the (light|heavy) mass`));
        masses.push(/of the (\w+) mass/.exec(told)[1]);
    }
    assert.deepEqual(masses, ["light", "light", "heavy", "light"]);
    await button("Step \u25b6").click();
    assert.match(await status(), /^After all 4 collisions: it never hits the floor again/);
    await button("\u25c0 Step").click();
    assert.match(await status(), /^Collision 4 of 4/);
    await button("Start").click();
    assert.match(await status(), /^Before the first/);
});

onPage("play moves the dumbbell and its point, and stops at the end or when asked", files.ten, async (page) => {
    const { of, button, position, dumbbell, point, status } = player(page);
    const before = [await dumbbell(), (await point()).bytes];
    // Inside the page, so that it is asked in time.
    const toggle = await button("Play").elementHandle();
    await of.locator(".scrub").evaluate((scrub, button) => new Promise((done) => {
        button.click();
        const watch = () => {
            if (Number(scrub.value) > 0.3) {
                button.click();
                done();
            } else {
                requestAnimationFrame(watch);
            }
        };
        watch();
    }), toggle);
    const stopped = await position();
    const now = [await dumbbell(), (await point()).bytes];
    assert.notDeepEqual(now[0], before[0]);
    assert.notDeepEqual(now[1], before[1]);
    await page.waitForTimeout(200);
    assert.equal(await position(), stopped);
    await of.getByLabel("Speed").selectOption("20");
    await button("Play").click();
    await page.waitForFunction((scrub) => scrub.value === scrub.max, await of.locator(".scrub").elementHandle());
    assert.match(await status(), /^After all 4 collisions/);
    assert.equal(await button("Play").count(), 1);
});

onPage("scrubbing shows any moment", files.full, async (page) => {
    const { of, status } = player(page);
    const scrub = of.locator(".scrub");
    const at = async (p) => {
        await scrub.evaluate((element, value) => {
            element.value = value;
            element.dispatchEvent(new Event("input"));
        }, p);
        return status();
    };
    assert.match(await at(3), /^Collision 3 of 10/);
    assert.match(await at(3.1), /^Between collisions 3 and 4 of 10/);
});

onPage("by keys alone: space plays, comma and full stop step, arrows scrub", files.ten, async (page) => {
    const { of, status, position, button } = player(page);
    await of.getByLabel("Speed").selectOption("0.25");
    await of.locator(".scrub").focus();
    await page.keyboard.press(".");
    assert.match(await status(), /^Collision 1 of 4/);
    await page.keyboard.press(".");
    await page.keyboard.press(",");
    assert.match(await status(), /^Collision 1 of 4/);
    await page.keyboard.press("ArrowRight");
    assert.ok((await position()) > 1);
    await page.keyboard.press(" ");
    assert.equal(await button("Pause").count(), 1);
    await page.keyboard.press(" ");
    assert.equal(await button("Play").count(), 1);
});

onPage("every control can be reached by the tab key and shows that it has the focus", files.full, async (page) => {
    const wanted = await page.locator("a[href], button, select, input, canvas[tabindex], summary").count();
    const reached = new Set();
    for (let i = 0; i < wanted + 60; ++i) {
        await page.keyboard.press("Tab");
        const found = await page.evaluate(() => {
            const e = document.activeElement;
            e.dataset.tabbed ??= String(Math.random());
            return e === document.body ? null : { id: e.dataset.tabbed, hidden: e.getClientRects().length === 0, outline: getComputedStyle(e).outlineStyle };
        });
        if (found) {
            assert.ok(!found.hidden && found.outline !== "none");
            reached.add(found.id);
        }
    }
    assert.ok(reached.size >= wanted, `${reached.size} of ${wanted}`);
});

onPage("where motion is to be reduced, play goes from collision to collision", files.ten, async (page) => {
    const { of, button } = player(page);
    await of.getByLabel("Speed").selectOption("5");
    const seen = await page.evaluate(() => {
        window.positions = new Set();
        const scrub = document.querySelector("#file-1 .scrub");
        const watch = () => {
            window.positions.add(scrub.value);
            requestAnimationFrame(watch);
        };
        watch();
        return true;
    });
    assert.ok(seen);
    await button("Play").click();
    await page.waitForFunction((scrub) => window.positions.has(scrub.max), await of.locator(".scrub").elementHandle());
    assert.deepEqual(await page.evaluate(() => [...window.positions]), ["0", "1", "2", "3", "4", "5"]);
}, { reducedMotion: "reduce" });

onPage("each witness of a staircase can be chosen", files.stairs, async (page) => {
    const { status } = player(page);
    const witness = page.getByLabel("Orbit", { exact: true });
    const n = await witness.locator("option").count();
    assert.equal(n, 17);
    for (let i = 0; i < n; ++i) {
        await witness.selectOption(String(i));
        const claimed = /: (\d+) collisions/.exec(await witness.locator("option").nth(i).textContent())[1];
        const shown = Number(/first of (\d+) collisions/.exec(await status())[1]);
        assert.ok(shown === Number(claimed) || shown === Number(claimed) + 1, `${i}: ${shown}, claimed ${claimed}`);
    }
});

onPage("your own start is followed, called not rigorous, and comes with the command that is", files.ten, async (page) => {
    const own = page.locator("#own");
    assert.match(await own.textContent(), /Not rigorous/);
    assert.match(await own.locator(".readout").first().textContent(), /In doubles: 3 collisions/);
    for (const [label, text] of [["mass ratio q", "10"], ["angle \u03c6", "1/3"], ["its velocity \u03c6\u2032", "1"], ["height y", "3"], ["its velocity y\u2032", "-1/2"]]) {
        await own.getByLabel(label, { exact: true }).fill(text);
    }
    await own.getByLabel("height y", { exact: true }).press("Enter");
    assert.match(await own.locator(".readout").first().textContent(), /In doubles: 1 collision\./);
    assert.match(await own.textContent(), /dumbbell trace 10 --phi 1\/3 --phidot 1 --y 3 --ydot -1\/2/);
    await own.getByLabel("height y", { exact: true }).evaluate((input) => {
        const clipboardData = new DataTransfer();
        clipboardData.setData("text", "dumbbell trace 4 --phi pi/2 --phidot 0 --y 2 --ydot -1");
        input.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
    });
    assert.match(await own.locator(".readout").first().textContent(), /In doubles: 1 collision\./);
    assert.match(await own.textContent(), /dumbbell trace 4 --phi pi\/2 --phidot 0 --y 2 --ydot -1/);
    await own.getByLabel("height y", { exact: true }).fill("0");
    await own.getByRole("button", { name: "Follow it" }).click();
    assert.match(await own.locator(".readout").first().textContent(), /above the floor/);
});

onPage("what is wrong with your own start is told by the field's name; ratios below 1 and corners as dumbbell trace has them", files.ten, async (page) => {
    const own = page.locator("#own");
    const field = (label) => own.getByLabel(label, { exact: true });
    const told = async () => {
        await own.getByRole("button", { name: "Follow it" }).click();
        return own.locator(".readout").first().textContent();
    };
    await field("height y").fill("abc");
    assert.equal(await own.locator("figure").isVisible(), true);
    assert.match(await told(), /^height y: \u201cabc\u201d is not a number/);
    assert.equal(await own.locator("figure").isVisible(), false); // nothing of the start before
    assert.doesNotMatch(await own.textContent(), /dumbbell trace 1/);
    assert.equal(await field("height y").getAttribute("aria-invalid"), "true");
    await field("height y").fill("1");
    await field("mass ratio q").fill("1/100");
    assert.match(await told(), /^Ratios below 1: the masses are swapped.*In doubles: 9 collisions\.$/);
    assert.equal(await field("height y").getAttribute("aria-invalid"), "false");
    assert.equal(await own.locator("figure").isVisible(), true);
    assert.match(await own.textContent(), /dumbbell trace 1\/100 /);
    for (const [label, text] of [["angle \u03c6", "0"], ["its velocity \u03c6\u2032", "0"], ["height y", "1"], ["its velocity y\u2032", "-1"]]) {
        await field(label).fill(text);
    }
    assert.match(await told(), /In doubles: 0 collisions, then both masses hit the floor at once, and no motion is defined\./);
    assert.match(await own.locator(".player .readout").textContent(), /both masses hit the floor at once/);
});

onPage("heights are told in rod lengths: the height that was typed is the height that is shown", files.ten, async (page) => {
    const own = page.locator("#own");
    await own.getByLabel("mass ratio q", { exact: true }).fill("4");
    await own.getByLabel("height y", { exact: true }).fill("1.25");
    await own.getByRole("button", { name: "Follow it" }).click();
    assert.match(await own.locator(".player .readout").textContent(), /y = 1\.25 rod lengths; velocity \(\u03c8, y\) 1, \u22120\.8\./);
});

onPage("a click on a box of initial conditions plays the orbit from its centre", files.starts, async (page) => {
    const canvas = page.locator("#file-1 .plane canvas").first();
    await canvas.hover({ position: { x: 500, y: 200 } });
    const told = await page.locator("#file-1 figure .readout").first().textContent();
    const count = /Exactly (\d+) collision/.exec(told)[1];
    await canvas.click({ position: { x: 500, y: 200 } });
    assert.match(await page.locator("#own .readout").first().textContent(), new RegExp(`In doubles: ${count} collision`));
});

for (const kind of ["starts", "incoming"]) {
    onPage(`a start is dragged, or moved by keys, through the picture of ${kind}: its certified and its simulated count agree`, files[kind], async (page) => {
        const canvas = page.locator("#file-1 .plane canvas").first();
        await canvas.scrollIntoViewIfNeeded();
        const told = () => page.locator("#file-1 figure .readout.start").textContent();
        assert.match(await told(), /Drag the dot/);
        const before = await canvas.getAttribute("data-window");
        const { x: left, y: top } = await canvas.boundingBox();
        const frame = JSON.parse(await canvas.getAttribute("data-frame"));
        const at = (u, v) => [left + frame.x + u * frame.width, top + frame.y + v * frame.height];
        const [phi, phidot, q] = await Promise.all(["phi", "phidot", "q"].map((name) => page.locator(`#own input[name=${name}]`).inputValue().then(Number)));
        const [x, y] = await placeOf(canvas, ...(kind === "starts" ? [phi, phidot] : [phi / Math.PI, phidot / Math.hypot(phidot, Math.sqrt(q))]));
        await page.mouse.move(left + x, top + y); // where it is at first
        await page.mouse.down();
        const seen = new Set();
        for (let i = 1; i <= 60; ++i) {
            await page.mouse.move(...at(0.5 + 0.4 * Math.sin(i), 0.5 + 0.4 * Math.sin(2.3 * i)));
            const text = await told();
            const [, exact, least, most, simulated] = /^Certified: (?:Exactly (\d+)|(\d+) to (\d+)) collision.*not rigorous: In doubles: (\d+) collision/.exec(text).map(Number);
            assert.ok(exact === simulated || (least <= simulated && simulated <= most), text);
            seen.add(exact);
        }
        await page.mouse.up();
        assert.ok(seen.has(1) && seen.has(2), [...seen].join());
        assert.equal(await canvas.getAttribute("data-window"), before, "the picture stays where it is");
        const now = await page.locator("#own input[name=phi]").inputValue();
        await canvas.focus();
        await page.keyboard.press("Shift+ArrowRight");
        assert.ok(Number(await page.locator("#own input[name=phi]").inputValue()) > Number(now));
    });
}

onPage("the choice of colours changes page and pictures at once", files.ten, async (page) => {
    const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const canvas = page.locator("#file-1 .player .plane canvas");
    const light = (await pixels(canvas)).bytes;
    await page.getByLabel("Colours").first().selectOption("dark");
    assert.equal(await background(), "rgb(20, 24, 31)");
    assert.notDeepEqual((await pixels(canvas)).bytes, light);
    await page.getByLabel("Colours").first().selectOption("light");
    assert.equal(await background(), "rgb(255, 255, 255)");
    assert.deepEqual((await pixels(canvas)).bytes, light);
    await page.emulateMedia({ colorScheme: "dark" }); // what was chosen stays, until it is the system's again
    assert.equal(await background(), "rgb(255, 255, 255)");
    await page.getByLabel("Colours").first().selectOption("auto");
    assert.equal(await background(), "rgb(20, 24, 31)");
});

test("a page begins with motion, once; where that is not wanted it stands still", async () => {
    const scrub = (page) => page.locator("#file-1 .player .scrub");
    const moving = await open(browser, report(place("ten.html"), files.ten), { moves: true });
    await moving.waitForFunction((input) => Number(input.value) > 0.1, await scrub(moving).elementHandle());
    await moving.close();
    const still = await open(browser, report(place("ten.html"), files.ten), { moves: true, reducedMotion: "reduce" });
    assert.equal(await player(still).button("Play").count(), 1);
    assert.equal(await scrub(still).inputValue(), "0");
    await still.close();
});

onPage("the mass ratio moves through the steps, where the longest orbit gains a collision", files.stairs, async (page) => {
    const birth = page.locator("#file-1 .birth");
    const told = () => birth.locator(".readout").textContent();
    assert.match(await told(), /^q = 10: the longest orbit, .*, has 4 collisions/);
    await birth.getByRole("button", { name: "Next step" }).click();
    assert.match(await told(), /^q = 11\.36\d*: .* has 5 collisions; the other one \(faint\) 4\.$/);
    await birth.getByRole("button", { name: "Step before" }).click();
    assert.match(await told(), /^q = 11\.36\d*: .* has 4 collisions; the other one \(faint\) 3\.$/);
    await birth.getByLabel("Mass ratio q").press("End");
    assert.match(await told(), /^q = 100: .* has 10 collisions/);
});

onPage("unfolded, the wedge has as many walls as the paper says on the line, and the floor the longest orbit's contacts", files.stairs, async (page) => {
    const figure = page.locator("#file-1 .unfolded");
    const told = (i) => figure.locator(".readout").nth(i).textContent();
    const dots = (i) => figure.locator("svg").nth(i).locator(".dot").evaluateAll((all) => all.map((dot) => [dot.classList[0], ...dot.getAttribute("d").match(/-?[\d.]+/g).slice(0, 2).map(Number)]));
    const turn = (slider, value) => slider.evaluate((input, to) => {
        input.value = to;
        input.dispatchEvent(new Event("input"));
    }, value);
    for (const [share, n] of [[0.05, 3], [0.5, 4], [0.6, 5], [0.88, 8], [1, 10]]) { // of the way from 1 to 100, on the scale of logarithms
        await turn(page.locator("#file-1 .birth .scrub"), 2000 * share);
        const walls = paperBound(100 ** share) - 1;
        assert.match(await told(0), new RegExp(`\u2309 = ${walls} walls at most`));
        assert.ok((await dots(0)).length <= walls && (await dots(0)).length >= walls / 3); // the others are outside of the picture
        assert.match(await told(1), new RegExp(`after N = ${n} collisions`));
        const contacts = await dots(1);
        assert.equal(contacts.length, n);
        assert.ok(contacts.every(([, x, y], i) => Math.abs(y + 100) < 0.02 && (i === 0 || x >= contacts[i - 1][1])), String(contacts)); // on one straight line
        assert.equal(contacts.filter(([mass]) => mass === "heavy").length, 1);
    }
    const line = page.getByLabel("Distance of the line from the vertex");
    assert.match(await told(0), /below the bridge/);
    await turn(line, 110);
    assert.match(await told(0), /It passes above all bridges\. But it crosses the walls 1 to 3 and 14 to 16 where/);
    await line.press("Home");
    assert.match(await told(0), /below the bridge/);
});

onPage("a start has a link, and a picture can be saved", files.ten, async (page, file) => {
    await page.locator("#own input[name=phi]").fill("\u03c0/6");
    await page.locator("#own input[name=phi]").press("Enter");
    const link = await page.getByText("A link to this start").getAttribute("href");
    assert.equal(link, "#start=10,pi%2F6,1,1,-0.8");
    const linked = await open(browser, file + link);
    assert.equal(await linked.locator("#own input[name=phi]").inputValue(), "pi/6");
    await linked.close();
    const map = await open(browser, report(place("starts.html"), files.starts) + link); // whose own start gives way
    assert.equal(await map.locator("#own input[name=phi]").inputValue(), "pi/6");
    await map.close();
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#file-1 .player").getByRole("button", { name: "Save" }).click()]);
    assert.match(download.suggestedFilename(), /^The-point-psi-y.*\.png$/);
    assert.equal((await readFile(await download.path())).toString("latin1", 1, 4), "PNG");
});
