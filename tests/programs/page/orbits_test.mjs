// The motions of the page against the program's enclosures, and the shipped witnesses against their certificates.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import test from "node:test";
import { angleFrom, fault, linkTo, linkedStart, numberFrom, startFrom } from "../../../web/src/start.js";
import { orbitFromStart, stateAt } from "../../../web/src/orbit.js";
import { parse, toNumber } from "../../../web/src/rational.js";
import { bridgeOrbit, extremalOrbits, longestOrbit, nextStep } from "../../../web/src/witness.js";
import { chartPoints } from "../../../web/src/chart_points.js";
import { floorAt } from "../../../web/src/flight.js";
import { certificates, dataIn, dumbbell, long, report, scratch, shipped } from "./program.mjs";

/// What trace says, whatever its exit code.
const spawnTrace = ({ q, phi, phidot, y, ydot }) => {
    const { stdout, stderr } = spawnSync(process.env.DUMBBELL_BIN, ["trace", q, "--phi", phi, "--phidot", phidot, "--y", y, "--ydot", ydot].map(String), { encoding: "utf8" });
    return stdout + stderr;
};

/// Reproducible numbers in [0, 1).
function random(seed) {
    return () => {
        seed = (seed * 1103515245 + 12345) % 2147483648;
        return seed / 2147483648;
    };
}

test("a start typed into the page has the collisions that dumbbell trace encloses, where it encloses them", () => {
    const next = random(7);
    const rounded = (x) => Number(x.toFixed(3));
    let collisions = 0;
    let decided = 0;
    for (let i = 0; i < 60; ++i) {
        const start = {
            q: [1, 2, 10, 100, 1000, 1e4][i % 6],
            phi: rounded(next() * 6 - 3), phidot: rounded(next() * 4 - 2), y: rounded(1.01 + next() * 2), ydot: rounded(-1.5 * next()),
        };
        const traced = JSON.parse(dumbbell("trace", start.q, "--phi", start.phi, "--phidot", start.phidot, "--y", start.y, "--ydot", start.ydot, "--json"));
        const orbit = orbitFromStart(start);
        const where = JSON.stringify(start);
        if (traced.outcome !== "exact") {
            continue;
        }
        ++decided;
        assert.equal(orbit.collisions.length, traced.least, where);
        const beta2 = 1 / (1 + 1 / start.q);
        traced.collisions.forEach((c, k) => {
            const mine = orbit.collisions[k];
            const close = (value, [lo, hi]) => assert.ok(value > lo - 1e-9 && value < hi + 1e-9, `${where} collision ${k + 1}: ${value} not in ${lo}..${hi}`);
            assert.equal(mine.heavy, c.mass === "heavy", where);
            close(mine.t, c.time);
            close(mine.psi + Math.PI / 2, c.phi);
            close(mine.y * beta2, c.y);
            close(mine.before.vy * beta2, c.ydot_before);
            close(mine.after.vy * beta2, c.ydot_after);
            close(mine.after.vpsi, c.phidot_after);
            ++collisions;
        });
    }
    console.log(`${decided} of 60 starts decided by trace, ${collisions} collisions compared`);
    assert.ok(decided >= 50);
});

const place = scratch();
const files = { ...certificates(place), long };
const dataOf = (...names) => dataIn(report(place("data.html"), ...names.map((name) => files[name]))).files;
const middle = ({ lo, hi }) => Math.sqrt(toNumber(parse(lo)) * toNumber(parse(hi)));

test("where both masses hit the floor at once no motion is defined, as dumbbell trace says", () => {
    const flat = { q: 10, phi: 0, phidot: 0, y: 1, ydot: -1 };
    const orbit = orbitFromStart(flat);
    assert.deepEqual([orbit.collisions.length, orbit.isCorner, orbit.complete], [0, true, false]);
    assert.ok(Math.abs(orbit.last.until - 1) < 1e-9); // falls from 1 with speed 1
    const traced = spawnTrace(flat);
    assert.match(traced, /no motion is defined|both masses/);
    const later = orbitFromStart({ ...flat, phi: 0.001 });
    assert.equal(later.isCorner, false);
});

test("each shipped witness has in the page the collisions that its certificate claims", () => {
    let witnesses = 0;
    for (const file of dataOf("stairs", "long", "ten", "full", "coin", "rod")) {
        for (const piece of file.pieces) {
            const { e, eta, forward, backward } = piece.witness;
            const [a, b] = [toNumber(parse(e)), toNumber(parse(eta))];
            const q = middle(piece);
            const orbit = bridgeOrbit(a, b, q, file.rho ? toNumber(parse(file.rho)) : 1 / q);
            const found = orbit.collisions.length;
            assert.ok(found >= 1 + forward + backward && (piece.upper === null || found <= piece.upper), `${file.name} ${piece.lo}: ${found}`);
            ++witnesses;
        }
    }
    console.log(`${witnesses} witnesses`);
    assert.ok(witnesses > 1000);
});

test("an orbit keeps its energy, stays above the floor, and collides on it", () => {
    for (const [e, eta, q, rho = 1 / q] of [[0.5, 0.5, 10], [0.5, 0.5, 100], [0.25, 0.5, 1e4], [1.2, 3, 50], [0.818, 0.0078, 4, 1], [0.1636, 0.00586, 9.717, 0.10492]]) {
        const orbit = bridgeOrbit(e, eta, q, rho);
        const energy = ({ vpsi, vy }) => vpsi ** 2 + q * vy ** 2;
        for (const c of orbit.collisions) {
            assert.ok(Math.abs(energy(c.before) - 1) < 1e-9 && Math.abs(energy(c.after) - 1) < 1e-9);
            assert.ok(Math.abs(c.y - floorAt(c.psi, rho)) < 1e-12);
        }
        for (let t = orbit.first.until; t < orbit.last.until; t += 0.05) {
            const { psi, y } = stateAt(orbit, t);
            assert.ok(y > floorAt(psi, rho) - 1e-9);
        }
    }
});

test("the two extremal orbits have N - 1 or N collisions, with the bridge's contact", () => {
    for (const [q, n] of [[10, 4], [100, 10], [1e4, 90], [1e6, 887]]) {
        const { top, corner } = extremalOrbits(q);
        const counts = [top.collisions.length, corner.collisions.length];
        assert.ok(counts.every((count) => count === n || count === n - 1), `${q}: ${counts}`);
        assert.ok(counts.includes(n) || counts[0] === n - 1);
    }
});

test("whatever falls hits the floor, however fast it turns, or it is said that doubles do not find where", () => {
    for (const [phidot, ydot] of [[1e7, -1], [-1e9, -1], [1e9, -1e-3], [1, -1e-5], [1e6, -1e6], [0, -1]]) {
        const { collisions, complete } = orbitFromStart({ q: 10, phi: 0.6571, phidot, y: 2, ydot });
        assert.ok(complete && collisions.length >= 1 && collisions.length <= 4, `${phidot} ${ydot}: ${collisions.length}`);
    }
    for (const [phidot, ydot] of [[1, -1e-300], [1e9, -1e-9], [1e9, -1e-308]]) {
        const { collisions, complete } = orbitFromStart({ q: 10, phi: 0.6571, phidot, y: 2, ydot });
        assert.ok(!complete || collisions.length >= 1, `${phidot} ${ydot}`);
    }
});

test("an orbit's states lie in the charts of a full section where its collisions are", () => {
    const orbit = bridgeOrbit(0.5, 0.5, 100);
    const [[t, eta]] = chartPoints(orbit, "contact");
    assert.ok(Math.abs(t - 0.5) < 1e-12 && Math.abs(eta - 0.5) < 1e-12);
    const departures = chartPoints(orbit, "departure");
    assert.equal(departures.length, 9); // all collisions of the light mass: each leaves across the cell
    assert.ok(departures.every(([e, slope]) => e > 0 && e < Math.PI / 2 && slope > 0 && slope < 2));
});

test("what is typed is read as a number, and what cannot start is told", () => {
    for (const [text, value] of [["3", 3], [" -1/2 ", -0.5], ["\u22120.5", -0.5], ["1e4", 10000], [".5", 0.5], ["+2", 2]]) {
        assert.equal(numberFrom(text), value);
    }
    for (const text of ["", "x", "1/2/3", "1,5", "--1", "0x10", "Infinity", "1 2"]) {
        assert.ok(Number.isNaN(numberFrom(text)), text);
    }
    const good = { q: 10, phi: 0, phidot: 1, y: 1, ydot: -1 };
    assert.equal(fault(good), null);
    assert.equal(fault({ ...good, q: 0.5 }), null); // the masses are swapped
    for (const q of [0, -1, 1e-320]) {
        assert.match(fault({ ...good, q }), /greater than 0/);
    }
    assert.match(fault({ ...good, y: 0 }), /above the floor/);
    assert.match(fault({ ...good, phi: -Math.PI / 2, y: 0.5 }), /above the floor/);
    assert.match(fault({ ...good, phidot: 0, ydot: 0 }), /rest/);
    assert.match(fault({ ...good, y: Infinity }), /doubles can hold/);
});

test("an angle is typed as for dumbbell trace, and a command of it can be pasted", () => {
    const close = (text, value) => assert.ok(Math.abs(angleFrom(text) - value) <= 1e-15 * Math.abs(value), `${text}: ${angleFrom(text)}`);
    for (const [text, value] of [["1/3", 1 / 3], ["30deg", Math.PI / 6], ["-22.5deg", -Math.PI / 8], ["pi", Math.PI], ["pi/2", Math.PI / 2], ["-2pi/3", (-2 * Math.PI) / 3], ["0.3pi", 0.3 * Math.PI]]) {
        close(text, value);
        const traced = JSON.parse(dumbbell("trace", "10", "--phi", text, "--phidot", "1", "--y", "3", "--ydot", "-1", "--json")).initial.phi;
        close(text, toNumber(parse(traced.lo)));
    }
    for (const text of ["deg", "1/3pi", "pix", "pi/", "pi/x", "30degrees", "twopi"]) {
        assert.ok(Number.isNaN(angleFrom(text)), text);
    }
    const command = dumbbell("certify", "100").split("\n").map((line) => /dumbbell trace .*/.exec(line)?.[0]).find(Boolean);
    const start = startFrom(`  ${command} --digits 20\n`);
    assert.equal(start.q, "100");
    const numbers = Object.fromEntries(Object.entries(start).map(([name, word]) => [name, numberFrom(word)]));
    assert.equal(orbitFromStart(numbers).collisions.length, 10);
    assert.deepEqual(startFrom("dumbbell trace 4 --ydot=-1 --y 2 --phidot 0 --phi=pi/2"), { q: "4", phi: "pi/2", phidot: "0", y: "2", ydot: "-1" });
    for (const text of ["", "3", "dumbbell trace 10", "dumbbell certify 10"]) {
        assert.equal(startFrom(text), null, text);
    }
});

test("the longest orbit gains a collision at the critical ratios, which are enclosed", () => {
    const lines = readFileSync(shipped("critical-ratios.tsv"), "utf8").split("\n").filter((line) => /^\d/.test(line)).slice(1, 60);
    const ends = { from: 1.5, to: 2500 };
    let q = ends.from;
    for (const [n, critical] of lines.map((line) => line.split("\t").map(Number))) {
        assert.equal(longestOrbit(q).longest.collisions.length, n - 1);
        const step = nextStep(q, +1, ends);
        if (step === null) {
            assert.ok(critical > ends.to);
            return;
        }
        assert.ok(Math.abs(step / critical - 1) < 1e-6, `${n}: ${step}, not ${critical}`);
        q = step * (1 + 1e-6);
        assert.ok(Math.abs(nextStep(q, -1, ends) / critical - 1) < 1e-6);
    }
});

test("a link has the start that it was made of, and a damaged one has none", () => {
    const words = ["10", "pi/6", "1", "2", "-1"];
    assert.deepEqual(Object.values(linkedStart(linkTo(words))), words);
    for (const hash of ["", "#own", "#start=", "#start=1,2,3,4", "#start=%E0%A4%A,1,1,1,1", "#start=1,1,1,1,1,1"]) {
        assert.equal(linkedStart(hash), null, hash);
    }
});
