// A certificate about the greatest number of collisions: staircase, cover, witnesses, tables.
import { birth } from "./birth.js";
import { chartPoints } from "./chart_points.js";
import { leafText, total } from "./charts.js";
import { Cover } from "./cover.js";
import { h, labelled, longTable, select, table } from "./dom.js";
import { foundations, heading, verifyBox } from "./file_tables.js";
import { plural, shortened, show } from "./numbers.js";
import { Player } from "./player.js";
import { parse, toNumber } from "./rational.js";
import { Staircase } from "./staircase.js";
import { colour, shade } from "./theme.js";
import { Unfolded } from "./unfolded.js";
import { bridgeOrbit, extremalOrbits } from "./witness.js";

const rangeText = ({ symbol, lo_text, hi_text }) => (lo_text === hi_text ? `${symbol} = ${shortened(lo_text)}` : `${symbol} from ${shortened(lo_text)} to ${shortened(hi_text)}`);

const valueText = ({ status, upper, lower }) =>
    status === "exact" ? `N = ${upper}` : upper - lower === 1 ? `N = ${lower} or ${upper}` : upper === null ? `N \u2265 ${lower}` : `${lower} \u2264 N \u2264 ${upper}`;

const bodyText = " (The contacts of the body are at the distances d1 \u2265 d2 from its centre of mass, \u03c1 = d2/d1; k is its radius of gyration, and Q = (d1/k)\u00b2.)";

/// The result in words.
function claimText({ pieces, symbol, rho, ratio, where, lo_text, hi_text, upper, lower }) {
    const number = (status) => pieces.filter((p) => p.status === status).length;
    const known = rho ? bodyText : "";
    if (lo_text === hi_text && pieces.length === 1 && pieces[0].status === "exact") {
        return `N(${symbol}) = ${upper}: with ${ratio} = ${shortened(lo_text)} no trajectory${where} hits the floor more than ${plural(upper, "time")}, and some trajectory hits it ${plural(upper, "time")}.${known}`;
    }
    const from = `${symbol} goes from ${shortened(lo_text)} to ${shortened(hi_text)}`;
    const result = upper === null ? `is at least ${lower} as ${from}` : upper === lower ? `is ${upper} as ${from}` : `goes from ${lower} to ${upper} as ${from}`;
    const gaps = number("gap") > 0 ? ` It is known at every ${symbol} but in ${plural(number("gap"), "narrow gap")} around its steps, where it is one of ${rho ? "two or three" : "two"} neighbouring numbers.` : "";
    const open = number("open") > 0 ? ` In ${plural(number("open"), "part")} of the range it is not decided.` : "";
    return `N(${symbol}) ${result}: the greatest number of collisions of any trajectory${where}, by the ${ratio}.${gaps}${open}${known}`;
}

function coverNote(file) {
    return file.section === "turning"
        ? "Why so few boxes? Every trajectory has a turning collision, or one contact of the heavy mass, and its count is that of the two rays there: only these states are covered, a set of two dimensions, not all collisions. And the rays are ordered (L5): a lower, flatter ray never has fewer collisions left, so one corner of a box bounds the box as a whole. At most mass ratios one box for each chart is enough; close to a step the bound must be tight only in a small region, where a few dozen boxes are."
        : "This cover has all collision states, counted forward only, so it needs many boxes where the turning section needs two: it does not use that every trajectory has a turning collision, and a box must settle each state by what follows.";
}

function coverSource(file) {
    const isCount = (kind) => kind.reason === "count";
    const choices = file.pieces.flatMap((piece, i) => piece.trees.map((tree) => ({
        text: `${file.pieces.length > 1 ? `${rangeText(piece)}: ${valueText(piece)}, ` : ""}chart ${tree.chart} (${tree.leaves.toLocaleString("en")} ${tree.leaves === 1 ? "box" : "boxes"})`,
        tree,
        chart: tree.chart,
        explain: `${i + 1}:${tree.chart}`,
        marks: (q) => marksOf(file, tree.chart, q, piece),
    })));
    const largest = choices.reduce((best, c, i) => (c.tree.leaves > choices[best].tree.leaves ? i : best), 0);
    return {
        title: `The boxes of the cover of ${file.name}`,
        choices,
        first: largest,
        kinds: file.kinds,
        describe: leafText,
        file: file.verify_file,
        note: coverNote(file),
        colourings: [
            {
                text: "by number of collisions",
                paint: (kind) => shade(kind.colour),
                label: (kind) => (isCount(kind) ? `at most ${total(kind)}` : kind.reason),
                order: (kind) => (isCount(kind) ? Number(total(kind)) : Infinity),
            },
            {
                text: "by reason",
                paint: (kind) => (isCount(kind) ? colour("--proved") : shade(kind.colour)),
                label: (kind) => kind.reason,
                order: (kind) => (isCount(kind) ? -1 : kind.reason === "outside" ? Infinity : file.kinds.indexOf(kind)),
            },
        ],
    };
}

/// The witness and the two extremal orbits in a chart's coordinates.
function marksOf(file, chart, q, piece) {
    const witness = piece.witness?.e && orbitOf(file, piece, q);
    const { top, corner } = extremalOrbits(q);
    if (chart === "bridge") {
        const start = piece.witness && [toNumber(parse(piece.witness.e)), toNumber(parse(piece.witness.eta))];
        return [
            { colour: "--mark-top", text: "extremal: over the top", points: [[Math.PI / 2, 0]] },
            { colour: "--mark-corner", text: "extremal: out of the corner", points: [[0, 0]] },
            ...(start ? [{ colour: "--mark", text: "witness", points: [start] }] : []),
        ];
    }
    if (chart !== "contact" && chart !== "departure" && chart !== "again") {
        return [];
    }
    const name = chart === "again" ? "contact" : chart;
    const chain = (orbit, ink, text) => ({ colour: ink, text, points: chartPoints(orbit, name) });
    return [
        ...(file.rho ? [] : [chain(top, "--mark-top", "extremal: over the top"), chain(corner, "--mark-corner", "extremal: out of the corner")]),
        ...(witness ? [chain(witness, "--mark", "witness")] : []),
    ].filter(({ points }) => points.length > 0);
}

/// A thin coin, a thin ring, or else a rod.
const shapeOf = (rho, q) => (rho !== 1 ? "rod" : q === 4 ? "disc" : q === 2 ? "ring" : "rod");

function orbitOf({ rho }, { witness }, q) {
    const [e, eta, height] = [witness.e, witness.eta, rho].map((text) => text && toNumber(parse(text)));
    return rho ? { ...bridgeOrbit(e, eta, q, height), shape: shapeOf(height, q) } : bridgeOrbit(e, eta, q, 1 / q);
}

const sameAngle = 0.1; // radians between two places of the floor that look like one

/// Whether it runs back as it came: then the same places are hit twice.
const retraces = ({ collisions }) => collisions.length > 1 && collisions.every(({ psi }, i) => Math.abs(psi - collisions.at(-1 - i).psi) < sameAngle);

/// The witness orbits, at the middle of their pieces.
function witnesses(file, moves) {
    const pieces = file.pieces.filter((piece) => piece.witness?.e);
    if (pieces.length === 0) {
        return null;
    }
    const player = new Player();
    const about = h("p", { class: "note" });
    const load = (i) => {
        const piece = pieces[i];
        const [lo, hi] = [toNumber(parse(piece.lo)), toNumber(parse(piece.hi))];
        const q = lo * Math.sqrt(hi / lo);
        const { chart } = piece.witness;
        const orbit = orbitOf(file, piece, q);
        const claimed = total(piece.witness);
        player.load(orbit);
        const found = orbit.collisions.length;
        about.replaceChildren(
            chart === "corner" ? `Motions close to the corner have ${plural(claimed, "collision")}` : `An orbit with ${plural(claimed, "collision")}, which the certificate has exactly`,
            `, for ${piece.lo === piece.hi ? "" : "every "}${rangeText(piece)}. Here ${chart === "corner" ? "one" : "it"} is computed in double precision at ${piece.symbol} = ${show(q, 10)}, as an illustration. `,
            retraces(orbit) ? "It retraces itself: from the middle on it runs back nearly the way it came, for time can be reversed. So the collisions stand in pairs, the first and the last one at one place. " : "",
            found < claimed && chart !== "corner" ? h("span", { class: "warning" }, `Doubles lose it after ${plural(found, "collision")}: so close to a step they are too coarse. The proof does not rest on them.`) : "",
        );
    };
    const last = pieces.length - 1;
    const choice = last > 0 && labelled("Orbit", select(pieces.map((p, i) => [i, `${rangeText(p)}: ${total(p.witness)} collisions`]), last, (i) => load(Number(i))));
    load(last);
    if (moves) {
        player.playOnce();
    }
    return h("figure", { class: "wide" }, h("div", { class: "controls" }, choice), player.element, about, h("figcaption", {},
        `${file.rho ? "The body" : "The dumbbell"}, and the same motion as a point above the floor curve. No gravity; the uniform horizontal motion is left out, and the dots are larger than the ${file.rho ? "contacts" : "point masses"}.`));
}

const mostRows = 200;

function piecesTable(file) {
    const isBounded = file.pieces.some((p) => p.paper);
    const ends = ({ lo_text: lo, hi_text: hi }) => (lo === hi ? shortened(lo) : `${shortened(lo)} to ${shortened(hi)}`);
    const paper = (p) => (p.paper ? (p.paper[0] === p.paper[1] ? String(p.paper[0]) : `${p.paper[0]} to ${p.paper[1]}`) : "");
    const row = (p) => [ends(p), valueText(p), ...(isBounded ? [paper(p)] : []), p.equal_masses ? "by L7" : p.symmetric ? "by L72" : file.section === "perpendicular" ? "by L87" : p.leaves.toLocaleString("en"), String(p.bits),
        p.witness ? `${total(p.witness)} collisions` : ""];
    const head = [file.rho ? "Q" : "mass ratio", "claimed", ...(isBounded ? ["the paper\u2019s bound"] : []), "boxes", "bits", "witness"];
    const boxesColumn = head.indexOf("boxes");
    const totals = Object.entries(file.totals).map(([reason, leaves]) => [reason, leaves.toLocaleString("en")]);
    return h(
        "details",
        { class: "tables", open: file.pieces.length <= 40 },
        h("summary", {}, "Piece by piece"),
        longTable("What is claimed", head, file.pieces.map(row), [boxesColumn, boxesColumn + 1], mostRows),
        totals.length > 0 && table("Boxes of all covers, by reason", ["reason", "boxes"], totals, [1]),
    );
}

const fewBoxes = 5;

/// Folded if it has little to show.
function coverPart(file) {
    const most = Math.max(...file.pieces.flatMap((piece) => piece.trees.map((tree) => tree.leaves)));
    const shown = new Cover(coverSource(file)).element;
    return most < fewBoxes
        ? h("details", {}, h("summary", {}, `The cover: ${most === 1 ? "1 box" : `${most} boxes`}`), shown)
        : h("div", {}, h("h3", {}, "The cover"), shown);
}

/// isFirst: of the page.
export function collisionsSection(file, constant, isAlone, isFirst) {
    const isRange = file.lo_text !== file.hi_text;
    const hasBoxes = file.pieces.some((piece) => piece.trees.length > 0);
    const played = witnesses(file, isFirst);
    const unfolded = file.has_orbits && new Unfolded();
    const born = birth(file, (q) => unfolded.show(q));
    return [
        heading(file, file.thing ?? `${file.system}, ${rangeText(file)}`),
        h("p", { class: "claim" }, claimText(file), file.section !== "turning" && !file.rho ? " The heavy mass hits the floor at most once." : ""),
        isRange && h("h3", {}, "The staircase"),
        isRange && new Staircase(file, constant).element,
        played && h("h3", {}, "The longest orbit"),
        played,
        unfolded && h("h3", {}, "Why not more? The wedge, unfolded"),
        unfolded && unfolded.element,
        born && h("h3", {}, "How one more collision is born"),
        born,
        hasBoxes && coverPart(file),
        piecesTable(file),
        h("h3", {}, "The certificate"),
        verifyBox(file),
        foundations(file, isAlone),
    ];
}
