// A certificate about initial conditions, or about all incoming trajectories: its boxes, from which orbits can be played, a start
// that can be dragged, and its shares.
import { Cover } from "./cover.js";
import { h, table } from "./dom.js";
import { foundations, heading, verifyBox } from "./file_tables.js";
import { plural, shortened, show } from "./numbers.js";
import { Player } from "./player.js";
import { fromDecimal, parse, subtract, toNumber } from "./rational.js";
import { colour, shade } from "./theme.js";

const names = { phi: "\u03c6: angle of the rod", phidot: "\u03c6\u2032: its velocity", y: "y: height of the centre of mass, rod lengths", ydot: "y\u2032: its velocity", q: "q: mass ratio, heavy over light", phi_over_pi: "\u03c6/\u03c0: angle of the rod where it comes in, over \u03c0", s: "s: sine of the angle between its flight and the vertical" };
const symbols = { phi: "\u03c6", phidot: "\u03c6\u2032", y: "y", ydot: "y\u2032", q: "q" };

const countText = ({ least, most }) => (most === least ? plural(least, "collision") : most === null ? "open: nothing is said" : `${least} to ${most} collisions`);
const isExact = (kind) => kind.most === kind.least;

const lift = 1 + 2 ** -20; // of the states of format-initial.md, section 8, above all walls

/// The start of a point of the tree: q, phi, phidot, y, ydot.
function startOf(file, point) {
    if (file.claim !== "incoming") {
        const [phi, phidot, y, ydot, q] = point;
        return [q, phi, phidot, y, ydot];
    }
    const [x, s] = point;
    const q = toNumber(parse(file.ratio));
    return [q, Math.PI * x, s * Math.sqrt(q / (1 - s * s)), (lift * q) / (1 + q), -q / (1 + q)];
}

/// What `beside` plays follows the start in the map.
function source(file, own, beside) {
    const follow = (point) => {
        const told = own.follow(startOf(file, point));
        if (own.orbit()) {
            beside.load(own.orbit());
        }
        return told;
    };
    const hasOpen = file.kinds.some((kind) => !isExact(kind));
    return {
        title: `The boxes of initial conditions of ${file.name}`,
        choices: [{ text: "box", tree: file.tree, chart: null, explain: "box", marks: null }],
        kinds: file.kinds,
        axisText: names,
        describe: (kind) => `${isExact(kind) ? "Exactly " : ""}${countText(kind)}${kind.first ? `, the first one of the ${kind.first} mass` : ""}`,
        file: file.verify_file,
        note: `${hasOpen ? `${file.hatched} ` : ""}Click a box (or press Enter for the one in the middle) to play the orbit from its centre.`,
        play: () => beside.isPlaying || beside.toggle(),
        simulate: follow,
        extra: (leaf) => windowText(file.windows.slice(2 * leaf, 2 * leaf + 2)),
        colourings: [
            {
                text: "by number of collisions",
                paint: (kind) => (kind.colour ? shade(kind.colour) : "hatched"),
                label: (kind) => (isExact(kind) ? plural(kind.least, "collision") : "not decided"),
                order: (kind) => (isExact(kind) ? Number(kind.least) : Infinity),
            },
            {
                text: "by the first mass to hit",
                paint: (kind) => (kind.first ? colour(`--${kind.first}`) : kind.colour ? shade(kind.colour) : "hatched"),
                label: (kind) => (kind.first ? `${kind.first} mass first` : isExact(kind) ? "no collision" : "not decided, or without a word about it"),
                order: (kind) => ["light", "heavy", null].indexOf(kind.first) + (isExact(kind) ? 0 : 1),
            },
        ],
    };
}

const windowText = ([from, until]) => (typeof from === "number" ? `, which comes between the times ${show(from)} and ${show(until)} (rounded)` : "");

const countsText = ({ least, most }) => (most === null ? `at least ${plural(least, "collision")}` : most === least ? `exactly ${plural(least, "collision")}` : `between ${least} and ${most} collisions`);

function claimText(file) {
    if (file.claim === "incoming") {
        return `Every trajectory that comes in from above at mass ratio q = ${plain(file.ratio)} and meets no corner has ${countsText(file)}. The table says which share of all of them, by their natural measure (uniform in \u03c6 and s), has exactly so many. Here 0 \u2264 s \u2264 1: the others are mirror images.`;
    }
    const axes = file.tree.axes.map(({ name, lo, hi }) => `${symbols[name]} ${lo === hi ? `= ${plain(lo)}` : `from ${plain(lo)} to ${plain(hi)}`}`).join(", ");
    return `Every trajectory that starts in the box ${axes} and meets no corner later has ${countsText(file)}; in each part of the box as many as the table says. Nothing is said about other starts, and so nothing about N(q).`;
}

/// As a decimal, if that is the same number.
function plain(text) {
    const decimal = String(toNumber(parse(text)));
    const isSame = !decimal.includes("e") && subtract(parse(text), fromDecimal(decimal)).n === 0n;
    return (isSame ? decimal : shortened(text)).replace("-", "\u2212");
}

/// The middle of the largest box with the most collisions.
function longest({ kinds }, tree) {
    const best = { rank: -1 };
    tree.walk(tree.axes.map(() => NaN), () => false, () => false, (box, kind) => {
        const share = tree.axes.reduce((part, { lo, hi }, a) => (hi > lo ? (part * (box[2 * a + 1] - box[2 * a])) / (hi - lo) : part), 1);
        const rank = isExact(kinds[kind]) ? Number(kinds[kind].least) + share / 2 : 0;
        Object.assign(best, rank > best.rank && { rank, middle: tree.axes.map((_, a) => (box[2 * a] + box[2 * a + 1]) / 2) });
    });
    return best.middle;
}

/// isFirst: of the page.
export function initialSection(file, own, isAlone, isFirst) {
    const isIncoming = file.claim === "incoming";
    const shares = file.shares.map(({ collisions, share, boxes }) => [collisions === null ? "not decided" : `exactly ${collisions}`, `${show(Number(share) * 100, 5)} %`, boxes.toLocaleString("en")]);
    const beside = new Player();
    const boxes = source(file, own, beside);
    const map = new Cover(boxes);
    map.startAt(longest(file, map.tree));
    boxes.simulate(map.fixed);
    if (isFirst) {
        beside.playOnce();
    }
    return [
        heading(file, isIncoming ? "Incoming trajectories" : "Initial conditions"),
        h("p", { class: "claim" }, claimText(file)),
        h("h3", {}, "The cover, and the motion from the start in it"),
        h("div", { class: "pair" }, map.element, beside.element),
        verifyBox(file),
        h("h3", {}, isIncoming ? "How many of them" : "How much of the box"),
        table("Shares (rounded)", ["collisions", "share", "boxes"], shares, [1, 2]),
        foundations(file, isAlone),
    ];
}
