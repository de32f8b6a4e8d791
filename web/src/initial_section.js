// A certificate about initial conditions: its boxes, from which orbits can be played, and its shares.
import { cover } from "./cover.js";
import { h, table } from "./dom.js";
import { foundations, verifyBox } from "./file_tables.js";
import { plural, shortened, show } from "./numbers.js";
import { colour, shade } from "./theme.js";

const names = { phi: "\u03c6: angle of the rod", phidot: "\u03c6\u2032: its velocity", y: "y: height of the centre of mass, rod lengths", ydot: "y\u2032: its velocity", q: "q: mass ratio, heavy over light" };
const symbols = { phi: "\u03c6", phidot: "\u03c6\u2032", y: "y", ydot: "y\u2032", q: "q" };

const countText = ({ least, most }) => (most === least ? plural(least, "collision") : most === null ? "open: nothing is said" : `${least} to ${most} collisions`);
const isExact = (kind) => kind.most === kind.least;

function source(file, play) {
    const hasOpen = file.kinds.some((kind) => !isExact(kind));
    return {
        title: `The boxes of initial conditions of ${file.name}`,
        choices: [{ text: "box", tree: file.tree, chart: null, explain: "box", marks: null }],
        kinds: file.kinds,
        countOf: (kind) => (isExact(kind) ? kind.least : null),
        axisText: names,
        describe: (kind) => `${isExact(kind) ? "Exactly " : ""}${countText(kind)}${kind.first ? `, the first one of the ${kind.first} mass` : ""}`,
        file: file.verify_file,
        note: `${hasOpen ? `${file.hatched} ` : ""}Click a box (or press Enter for the one in the middle) to play the orbit from its centre below.`,
        play,
        extra: (leaf) => windowText(file.windows.slice(2 * leaf, 2 * leaf + 2)),
        colourings: [
            {
                text: "by number of collisions",
                isByCount: true,
                paint: (kind) => (kind.colour ? shade(kind.colour) : "hatched"),
                label: (kind) => (isExact(kind) ? plural(kind.least, "collision") : "not decided"),
                order: (kind) => (isExact(kind) ? kind.least : 1e9),
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

function claimText(file) {
    const axes = file.tree.axes.map(({ name, lo, hi }) => `${symbols[name]} ${lo === hi ? `= ${plain(lo)}` : `from ${plain(lo)} to ${plain(hi)}`}`).join(", ");
    const count = file.most === null ? `at least ${plural(file.least, "collision")}` : file.most === file.least ? `exactly ${plural(file.least, "collision")}` : `between ${file.least} and ${file.most} collisions`;
    return `Every trajectory that starts in the box ${axes} and meets no corner later has ${count}; in each part of the box as many as the table says. Nothing is said about other starts, and so nothing about N(q).`;
}

const plain = (text) => shortened(text.endsWith("/1") ? text.slice(0, -2) : text).replace("-", "\u2212");

export function initialSection(file, play, isAlone) {
    const shares = file.shares.map(({ collisions, share, boxes }) => [collisions === null ? "not decided" : `exactly ${collisions}`, `${show(Number(share) * 100, 5)} %`, boxes.toLocaleString("en")]);
    return [
        h("h2", {}, "Initial conditions"),
        h("p", { class: "claim" }, claimText(file)),
        verifyBox(file),
        h("h3", {}, "The cover"),
        cover(source(file, play)).element,
        h("h3", {}, "How much of the box"),
        table("Shares (rounded)", ["collisions", "share", "boxes"], shares, [1, 2]),
        foundations(file, isAlone),
    ];
}
