// Pixels: pictures are not blank, and have the right colours where it is known what is there.
import assert from "node:assert/strict";
import test from "node:test";
import { readFileSync } from "node:fs";
import { gunzipSync } from "node:zlib";
import { colour, inkShare, open, pixels, placeOf, settled, stage } from "./browser.mjs";
import { dataIn, dumbbell, report } from "./program.mjs";

const { browser, files, onPage, place } = await stage();

const plain = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)).join(",");
/// The colour that a page's data give to a number of collisions.
const countInk = (report, count, scheme = "light") => {
    const { colour } = dataIn(report).files[0].kinds.find((kind) => (kind.reason === "count" ? 1 + kind.forward + kind.backward : kind.least === kind.most && kind.least) === count);
    return plain(colour[scheme === "dark" ? 1 : 0]);
};
const near = (a, b) => a !== "" && a.split(",").every((part, i) => Math.abs(part - b.split(",")[i]) <= 12);

const everyKind = () => report(place("kinds.html"), files.ten);

/// Whether a pixel of this colour is within `reach` of the place.
function has(picture, [x, y], ink, reach = 3) {
    for (let dx = -reach; dx <= reach; ++dx) {
        for (let dy = -reach; dy <= reach; ++dy) {
            if (near(picture.at(x + dx, y + dy), ink)) {
                return true;
            }
        }
    }
    return false;
}

/// A cover of few boxes is folded.
async function unfold(page) {
    await page.locator("summary", { hasText: "The cover" }).click();
    await settled(page);
}

for (const colorScheme of ["light", "dark"]) {
    onPage(`the staircase has its steps, its gaps and the paper's bound where they are (${colorScheme})`, files.stairs, async (page) => {
        const canvas = page.locator("#file-1 .map canvas").first();
        const picture = await pixels(canvas);
        assert.ok(inkShare(picture) > 0.01);
        const proved = await colour(page, "--proved");
        for (const [q, n] of [[2, 3], [8, 4], [15, 5], [25, 6], [40, 7], [50, 8], [70, 9], [90, 10]]) {
            assert.ok(has(picture, await placeOf(canvas, Math.log10(q), n), proved), `N(${q}) = ${n}`);
            assert.ok(!has(picture, await placeOf(canvas, Math.log10(q), n + 1), proved), `N(${q}) is not ${n + 1}`);
        }
        assert.ok(has(picture, await placeOf(canvas, Math.log10(4.6033388), 3.5), await colour(page, "--gap")));
        assert.ok(has(picture, await placeOf(canvas, Math.log10(4), 5), await colour(page, "--paper"), 8));
        assert.ok(has(picture, await placeOf(canvas, Math.log10(50), 2 + 0.8855951 * Math.sqrt(50)), await colour(page, "--growth"), 6));
    }, { colorScheme });

    onPage(`a cover of one box is one colour, and beside it there is none (${colorScheme})`, files.ten, async (page, ten) => {
        await unfold(page);
        const canvas = page.locator("#file-1 .map canvas").first();
        const picture = await pixels(canvas);
        // The cover of q = 10 has a box with 4 collisions in the chart bridge, and one with 3 in the other chart.
        for (const [e, eta] of [[0.2, 9], [1, 6], [1.9, 14]]) {
            assert.ok(near(picture.at(...(await placeOf(canvas, e, eta))), countInk(ten, 4, colorScheme)));
        }
        assert.equal(picture.at(...(await placeOf(canvas, 2.03, 7.3))), "");
    }, { colorScheme });
}

/// The count of a collision file's box at a point of the full section's chart departure, by walking through the file's own text.
function countAt(text, e, eta) {
    const lines = text.split("\n");
    let i = lines.indexOf("chart departure") + 1;
    const box = { e: [0, 2], eta: [0, 2] };
    const skip = () => {
        for (let missing = 1; missing > 0; ++i) {
            missing += lines[i].startsWith("split") ? 1 : -1;
        }
    };
    while (lines[i].startsWith("split")) {
        const axis = lines[i].slice(6);
        const middle = (box[axis][0] + box[axis][1]) / 2;
        ++i;
        if ({ e, eta }[axis] > middle) {
            skip();
            box[axis][0] = middle;
        } else {
            box[axis][1] = middle;
        }
    }
    return 1 + Number(lines[i].split(" ")[1]);
}

onPage("boxes have the colours of their counts: the file's own lines against the picture", files.full, async (page, full) => {
    const text = gunzipSync(readFileSync(files.full)).toString();
    const canvas = page.locator("#file-1 .map canvas").first();
    const points = [[0.1, 0.2], [0.3, 1.5], [1.5, 0.3], [0.9, 0.2], [1.2, 0.9], [0.55, 1.7], [1.9, 0.3]];
    const picture = await pixels(canvas);
    for (const [e, eta] of points) {
        const ink = countInk(full, countAt(text, e, eta));
        const at = await placeOf(canvas, e, eta);
        assert.ok(has(picture, at, ink, 3), `(${e}, ${eta}) has ${picture.at(...at)}, not ${ink}`);
    }
});

onPage("pointing at a box tells its range, its reason and the verifier's command, which explains that box", files.full, async (page) => {
    const canvas = page.locator("#file-1 .map canvas").first();
    await canvas.scrollIntoViewIfNeeded();
    const [x, y] = await placeOf(canvas, 0.9, 0.2);
    await canvas.hover({ position: { x, y } });
    const told = await page.locator("#file-1 .map .readout").first().textContent();
    assert.match(told, /count \d+: at most \d+ later collisions/);
    const command = /dumbbell (verify --explain \S+ \S+)/.exec(told)[1].split(" ");
    assert.equal(command.pop(), "full-100.dbc.gz"); // without a folder
    const explained = dumbbell(...command, files.full);
    const range = /e ([\d.]+) to ([\d.]+), eta ([\d.]+) to ([\d.]+)/.exec(told).slice(1).map(Number);
    assert.ok(range[0] <= 0.9 && 0.9 <= range[1] && range[2] <= 0.2 && 0.2 <= range[3], told);
    assert.ok(explained.includes(`within [${range[0]}`), explained.slice(0, 400));
    assert.match(explained, new RegExp(/count \d+/.exec(told)[0]));
});

onPage("the extremal orbits and the witness are marked", files.ten, async (page) => {
    await unfold(page);
    const canvas = page.locator("#file-1 .map canvas").first();
    const picture = await pixels(canvas);
    for (const [e, eta, name] of [[0.5, 0.5, "--mark"], [Math.PI / 2, 0, "--mark-top"], [0, 0, "--mark-corner"]]) {
        assert.ok(has(picture, await placeOf(canvas, e, eta), await colour(page, name), 2), name);
    }
});

test("a colour means the same in the page and in the pictures of dumbbell plot, light and dark", async () => {
    const wide = place("wide.dbc"); // with a gap
    dumbbell("certify", "4.5:4.7", "--gap", "1e-2", "--out", wide);
    const names = { proved: "stroke", paper: "stroke", growth: "stroke", gap: "fill", light: "fill", heavy: "fill", ground: "fill" };
    const pictures = [["staircase", wide], ["orbit", files.ten], ["phase", files.incoming]].map(([kind, file], i) => {
        dumbbell("plot", kind, file, "--out", place(`${i}.svg`));
        return readFileSync(place(`${i}.svg`), "utf8");
    });
    const incoming = report(place("incoming.html"), files.incoming);
    const page = { light: await open(browser, everyKind(), { colorScheme: "light" }), dark: await open(browser, everyKind(), { colorScheme: "dark" }) };
    let compared = 0;
    for (const scheme of ["light", "dark"]) {
        for (const picture of pictures) {
            const [light, dark] = picture.match(/<style>(.*?)@media \(prefers-color-scheme:dark\)\{(.*)\}<\/style>/s).slice(1);
            const rules = scheme === "light" ? light : dark;
            for (const [name, property] of Object.entries(names)) {
                const found = new RegExp(`\\.${name}\\{${property}:(#\\w{6})\\}`).exec(rules);
                if (found) {
                    assert.equal(await colour(page[scheme], `--${name === "ground" ? "floor" : name}`), plain(found[1]), `${scheme} ${name}`);
                    ++compared;
                }
            }
            const counts = [...rules.matchAll(/\.n(\d+)\{fill:(#\w{6})\}/g)].map(([, n, ink]) => [Number(n), ink]);
            for (const [n, ink] of counts) {
                assert.equal(countInk(incoming, n, scheme), plain(ink), `${scheme} ${n}`);
                ++compared;
            }
        }
    }
    assert.ok(compared >= 2 * (4 + 3 + 3), String(compared));
    await Promise.all(Object.values(page).map((of) => of.close()));
});

onPage("initial conditions are coloured by their exact counts, which trace confirms", files.starts, async (page, starts) => {
    const canvas = page.locator("#file-1 .map canvas").first();
    const picture = await pixels(canvas);
    for (const [phi, phidot] of [[1.4, 0.2], [0.3, -0.4], [2.8, 0.1]]) {
        const traced = JSON.parse(dumbbell("trace", 10, "--phi", phi, "--phidot", phidot, "--y", "3/2", "--ydot", -1, "--json"));
        const ink = countInk(starts, traced.least);
        assert.ok(has(picture, await placeOf(canvas, phi, phidot), ink, 2), `(${phi}, ${phidot}): ${traced.least}`);
    }
});

onPage("the dumbbell and its point are drawn", [files.ten], async (page) => {
    const point = await colour(page, "--point");
    const dumbbell = page.locator("#file-1 .dumbbell svg");
    const places = await dumbbell.evaluate((svg) => {
        const box = svg.getBoundingClientRect();
        return ["light", "heavy"].map((kind) => {
            const line = [...svg.querySelectorAll(`line.${kind}`)].at(-1);
            const [x, y] = ["x1", "y1"].map((name) => Number(line.getAttribute(name)));
            const { x: px, y: py } = new DOMPoint(x, y).matrixTransform(svg.getScreenCTM());
            return { x, y, ink: getComputedStyle(line).stroke.match(/\d+/g).join(","), isSeen: px > box.left && px < box.right && py > box.top && py < box.bottom };
        });
    });
    assert.deepEqual(places.map(({ ink }) => ink), await Promise.all(["--light", "--heavy"].map((name) => colour(page, name))));
    assert.ok(places.every(({ isSeen }) => isSeen));
    assert.ok(Math.abs(Math.hypot(places[0].x - places[1].x, places[0].y - places[1].y) - 1) < 1e-9); // a rod long
    const plane = page.locator("#file-1 .player .plane canvas");
    const picture = await pixels(plane);
    assert.ok(inkShare(picture) > 0.05);
    let seen = false;
    for (let x = 0; x < picture.width - 1 && !seen; ++x) {
        for (let y = 0; y < picture.height - 1 && !seen; ++y) {
            seen = picture.at(x, y) === point;
        }
    }
    assert.ok(seen);
});
