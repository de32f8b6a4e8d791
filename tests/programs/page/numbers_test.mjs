import assert from "node:assert/strict";
import test from "node:test";
import { paperBound, paperStep } from "../../../web/src/paper.js";
import { fromDecimal, fromNumber, parse, subtract, toDecimal, toNumber } from "../../../web/src/rational.js";
import { show } from "../../../web/src/numbers.js";
import { angleTicks, countTicks, linearTicks, logTicks } from "../../../web/src/ticks.js";
import { BoxTree } from "../../../web/src/tree.js";
import { Clock } from "../../../web/src/clock.js";
import { dataIn, report, scratch, shipped } from "./program.mjs";

test("rationals become the nearest doubles or their neighbours, whatever their length", () => {
    for (const x of [1, 0.1, 1 / 3, 123456.789, 2 ** -1000, 1e300]) {
        assert.equal(toNumber(fromNumber(x)), x);
        assert.equal(toNumber(fromNumber(-x)), -x);
    }
    assert.ok(Math.abs(toNumber(parse("1/3")) - 1 / 3) < 1e-16);
    assert.equal(toNumber(parse(`${10n ** 500n}/${10n ** 499n}`)), 10);
    assert.equal(toNumber(parse("0/1")), 0);
});

test("decimals are cut off and read back exactly", () => {
    assert.equal(toDecimal(parse("10/3"), 5), "3.33333");
    assert.equal(toDecimal(parse("1/1024"), 0), "0");
    assert.equal(toDecimal(parse("1/1024"), 4), "0.0009");
    assert.equal(toNumber(subtract(parse("10/3"), fromDecimal("3.33333"))).toExponential(3), "3.333e-6");
});

test("a difference far below what doubles tell apart is exact", () => {
    const q = 46033388487517003n;
    const near = parse(`${q * 10n ** 40n + 1n}/${10n ** 56n}`);
    assert.equal(toNumber(subtract(near, parse(`${q}/${10n ** 16n}`))), 1e-56);
});

test("the paper's bound is the program's, at steps and between", () => {
    const place = scratch();
    const [stairs] = dataIn(report(place("page.html"), shipped("stairs-1-1e6.dbc.gz"))).files;
    for (const { lo, hi, paper } of stairs.pieces) {
        assert.deepEqual([lo, hi].map((q) => paperBound(toNumber(parse(q)))), paper, `${lo} ${hi}`);
    }
    assert.deepEqual([1, 1.0001, 3, 3.0001, 10, 100, 1e4, 1e6].map(paperBound), [3, 4, 4, 5, 7, 17, 159, 1572]);
    for (let m = 2; m < 500; ++m) {
        assert.equal(paperBound(paperStep(m)), m + 1);
        assert.equal(paperBound(paperStep(m) * (1 + 1e-9)), m + 2);
    }
});

test("marks lie in the window, are round, and have different texts", () => {
    for (const ticks of [linearTicks(0, 1, 6), linearTicks(4.60333, 4.60334, 6), linearTicks(-2e-8, 3e-8, 5), logTicks(0, 6, 8), logTicks(0.6, 0.7, 8),
        logTicks(0, 2, 8), angleTicks(-Math.PI, Math.PI, 6), angleTicks(0, 1, 6), angleTicks(-20, 20, 6), countTicks(0, 17.3, 8)]) {
        assert.ok(ticks.length >= 2 && ticks.length <= 20, String(ticks.length));
        assert.equal(new Set(ticks.map((t) => t.text)).size, ticks.length, ticks.map((t) => t.text).join(" "));
    }
    assert.deepEqual(countTicks(0, 4, 20).map((t) => t.text), ["0", "1", "2", "3", "4"]);
    assert.deepEqual(angleTicks(-Math.PI, Math.PI, 4).map((t) => t.text), ["\u2212\u03c0", "\u2212\u03c0/2", "0", "\u03c0/2", "\u03c0"]);
    assert.equal(show(-0.25), "\u22120.25");
    assert.equal(show(1e-20), "1e\u221220");
});

const tree = new BoxTree({
    nodes: [-1, -2, 3, 1, 2],
    axes: [{ name: "e", lo: "0/1", hi: "2/1" }, { name: "eta", lo: "0/1", hi: "8/1" }, { name: "q", lo: "10/1", hi: "10/1" }],
    leaves: 3,
    stands_for: [],
});

test("a point is found in its box, with the path that the verifier takes", () => {
    assert.deepEqual(tree.find([0.5, 5, 10]), { box: Float64Array.of(0, 1, 4, 8, 10, 10), kind: 1, path: "01", number: 1, standsFor: 1 });
    assert.equal(tree.find([1.5, 5, 10]).path, "1");
    assert.equal(tree.find([0.5, 1, 10]).kind, 3);
    assert.equal(tree.find([2.5, 1, 10]), null);
    assert.equal(tree.find([0.5, 1, 11]), null);
});

test("a walk visits every box of a slice once, and what is small as one", () => {
    const visits = (fixed, small = () => false) => {
        const kinds = [];
        tree.walk(fixed, () => false, small, (box, kind) => kinds.push(kind));
        return kinds;
    };
    assert.deepEqual(visits([NaN, NaN, 10]), [3, 1, 2]);
    assert.deepEqual(visits([NaN, 6, 10]), [1, 2]);
    assert.deepEqual(visits([0.2, NaN, 10]), [3, 1]);
    assert.deepEqual(visits([NaN, NaN, 10], () => true), [3]);
});

test("the clock shows a flight from its start to its end, slower at collisions, and never runs back", () => {
    const at = (t) => ({ t });
    const orbit = { collisions: [at(1), at(2), at(5)], first: { t: 1, until: 0 }, last: { t: 5, until: 6 } };
    const clock = new Clock(orbit);
    assert.deepEqual([0, 1, 2, 3, 4].map((p) => clock.time(p)), [0, 1, 2, 5, 6]);
    for (let p = 0; p < 4; p += 0.01) {
        assert.ok(clock.time(p + 0.01) > clock.time(p));
    }
    assert.ok(clock.time(2.05) - 2 < 0.5 * 0.05 * 3);
    assert.equal(clock.later(0, 1e9), 4);
});
