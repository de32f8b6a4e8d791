// The staircase N(q): what the pieces of a certificate say, the paper's bound, 2 + C sqrt q. Two kinds of window: log q over the
// whole range, and, close to a step, the exact distance from it (a gap can be narrower than doubles can tell apart).
import { h, labelled, output, select } from "./dom.js";
import { plural, shortened, show } from "./numbers.js";
import { growth, paperBound, paperStep } from "./paper.js";
import { Plane } from "./plane.js";
import { fromDecimal, fromNumber, parse, subtract, toDecimal, toNumber } from "./rational.js";
import { numberFrom } from "./start.js";
import { colour, hatching } from "./theme.js";
import { countTicks, linearTicks, logTicks } from "./ticks.js";

const around = "around"; // the choice that the typed ratio is
const mostPaperSteps = 4000; // drawn; more of them are closer than pixels
const nearPaper = 7; // so close to the maximum, the paper's bound is shown beside it; else it is named

/// q as x of the plane and back; `origin` is an exact decimal in a window close to a step.
const scales = {
    log: (ratio) => ({
        x: (exact) => Math.log10(toNumber(exact)),
        xOf: (q) => Math.log10(q),
        q: (x) => 10 ** x,
        text: (x) => show(10 ** x, 10),
        ticks: logTicks,
        label: `${ratio}${ratio.endsWith("q") ? ", heavy over light" : ""} (logarithmic)`,
    }),
    local: (origin) => {
        const from = fromDecimal(origin);
        return {
            x: (exact) => toNumber(subtract(exact, from)),
            xOf: (q) => toNumber(subtract(fromNumber(q), from)),
            q: (x) => toNumber(from) + x,
            text: (x) => `${shortened(origin)} ${x < 0 ? "\u2212" : "+"} ${show(Math.abs(x), 4)}`,
            ticks: linearTicks,
            label: `q \u2212 ${shortened(origin)}`,
        };
    },
};

const hint = matchMedia("(hover: none)").matches ? "Tap the staircase to read it." : "Point at the staircase, or move it with the arrow keys.";

export class Staircase {
    constructor(file, constant) {
        this.file = file;
        this.constant = constant;
        this.pieces = file.pieces.map((piece) => ({ ...piece, q0: parse(piece.lo), q1: parse(piece.hi) }));
        this.base = [file.upper, file.lower].some((n) => typeof n === "bigint") ? BigInt(file.lower) : null;
        this.isCompared = file.has_orbits && this.base === null;
        this.gaps = this.pieces.filter((piece) => piece.status === "gap");
        this.rescale(scales.log(this.file.ratio));
        const top = Math.max(...this.pieces.map((p) => Math.max(this.height(p.upper ?? p.lower), this.paper(p))));
        this.home = { x0: this.x0[0], x1: this.x1.at(-1), y0: 0, y1: top * 1.06 + 0.5 };
        const space = (this.home.x1 - this.home.x0) * 0.015;
        this.home.x0 -= space;
        this.home.x1 += space;
        this.plane = new Plane({
            title: `Staircase: the greatest number of collisions against the ${file.ratio}, from ${file.lo_text} to ${file.hi_text}`,
            home: this.home,
            height: 400,
            xLabel: () => this.scale.label,
            yLabel: this.base === null ? "collisions N(q)" : `collisions N(q) \u2212 ${this.base}`,
            xTicks: (...of) => this.scale.ticks(...of),
            yTicks: countTicks,
            least: { x: 1e-300, y: 3 },
            draw: (plane) => this.draw(plane),
            probe: (x, y) => this.tell(x),
        });
        this.readout = output("readout", hint);
        this.element = h("figure", { class: "wide map" }, this.controls(), this.plane.element, this.readout, this.caption());
    }

    /// A count as the plane has it: where doubles do not tell counts apart, its distance from the least one.
    height(count) {
        return this.base === null ? count : Number(BigInt(count) - this.base);
    }

    /// The greatest value of the paper's bound on the piece.
    paper(piece) {
        return this.isCompared ? (piece.paper?.[1] ?? 0) : 0;
    }

    rescale(scale) {
        this.scale = scale;
        this.x0 = this.pieces.map((p) => scale.x(p.q0));
        this.x1 = this.pieces.map((p) => scale.x(p.q1));
    }

    controls() {
        const steps = this.gaps.map((gap, i) => [i, `${gap.lower} \u2192 ${gap.upper} at q = ${show(toNumber(gap.q0), 9)}`]);
        const choices = [["", "the whole range"], [around, "around the ratio typed"], ...steps];
        const typed = h("input", { type: "text", inputmode: "decimal", size: "12", placeholder: "e.g. 4.6", "aria-label": "around q =" });
        this.choice = select(choices, "", (value) => (value === "" ? this.whole() : value === around ? this.show(typed.value) : this.goto(this.gaps[Number(value)])));
        const go = (event) => {
            event.preventDefault();
            this.show(typed.value);
        };
        return h(
            "div",
            { class: "controls" },
            labelled("Show", this.choice),
            h("form", { class: "labelled", onsubmit: go }, h("span", {}, "around q ="), typed, h("button", { type: "submit" }, "Go")),
        );
    }

    /// A window around a mass ratio as it was typed; below 1 the masses are swapped.
    show(text) {
        const q = numberFrom(text);
        const x = Math.log10(q < 1 ? 1 / q : q);
        if (!(q > 0 && x >= this.home.x0 && x <= this.home.x1)) {
            this.choice.value = "";
            this.whole();
            this.readout.textContent = q > 0 ? `Nothing is claimed about q = ${text.trim()}.` : `\u201c${text}\u201d is not a mass ratio: write a number like 4.6 or 9/2.`;
            return;
        }
        this.whole();
        this.choice.value = around;
        this.plane.show({ x0: x - 0.02, x1: x + 0.02 });
        this.fitCounts();
        this.tell(x);
    }

    whole() {
        this.choice.value = "";
        this.rescale(scales.log(this.file.ratio));
        this.plane.setHome(this.home);
    }

    /// A window of nine times the gap's width, measured from an exact decimal just below it.
    goto(gap) {
        const width = toNumber(subtract(gap.q1, gap.q0));
        const places = Math.max(0, Math.ceil(-Math.log10(width)) + 1);
        this.rescale(scales.local(toDecimal(gap.q0, places)));
        const x0 = this.scale.x(gap.q0);
        this.plane.setHome({ x0: x0 - 4 * width, x1: x0 + 5 * width, ...this.heights([gap]) });
        this.tell(x0 + width / 2);
    }

    /// A window of counts that fits these pieces.
    heights(pieces) {
        const least = Math.min(...pieces.map((p) => this.height(p.lower)));
        const most = Math.max(...pieces.map((p) => this.height(p.upper ?? p.lower)));
        const paper = Math.max(...pieces.map((p) => this.paper(p)));
        return { y0: Math.max(0, least - 2.5), y1: (paper - most <= nearPaper ? Math.max(most, paper) : most + 1.5) + 1.5 };
    }

    /// Heights that fit what the window shows.
    fitCounts() {
        const { x0, x1 } = this.plane.window;
        const shown = this.pieces.filter((_, i) => this.x1[i] >= x0 && this.x0[i] <= x1);
        if (shown.length > 0) {
            this.plane.show(this.heights(shown));
        }
    }

    draw(plane) {
        this.pieces.forEach((piece, i) => {
            if (this.x1[i] >= plane.window.x0 && this.x0[i] <= plane.window.x1 && piece.status !== "exact") {
                this.drawUndecided(plane, piece, i);
            }
        });
        if (this.isCompared) {
            this.drawPaper(plane);
            this.drawGrowth(plane);
        }
        const c = plane.context; // all in one path: there may be very many
        c.lineWidth = 3;
        c.strokeStyle = colour("--proved");
        c.beginPath();
        this.pieces.forEach((piece, i) => {
            if (piece.status === "exact") {
                const y = plane.Y(this.height(piece.upper));
                const x = plane.X(this.x0[i]);
                c.moveTo(x, y);
                c.lineTo(Math.max(x + 1.5, plane.X(this.x1[i])), y);
            }
        });
        c.stroke();
    }

    /// A gap: a riser between its two values, at least a thin one; an open piece: the whole height.
    drawUndecided(plane, { status, lower, upper }, i) {
        const c = plane.context;
        const x = plane.X(this.x0[i]);
        const width = Math.max(1.5, plane.X(this.x1[i]) - x);
        const isGap = status === "gap";
        const top = isGap ? plane.Y(this.height(upper)) : plane.frame.y;
        c.fillStyle = isGap ? colour("--gap") : hatching(c);
        c.fillRect(x, top, width, Math.max(1, plane.Y(this.height(lower)) - top));
    }

    drawPaper(plane) {
        const last = toNumber(this.pieces.at(-1).q1);
        const from = Math.max(1, this.scale.q(plane.window.x0));
        const to = Math.min(last, this.scale.q(plane.window.x1));
        let bound = paperBound(from);
        if (bound > plane.window.y1) {
            const c = plane.context;
            c.font = `12px ${colour("--font")}`;
            c.fillStyle = colour("--paper");
            c.textAlign = "right";
            c.textBaseline = "top";
            c.fillText(`\u2191 the paper\u2019s bound: ${bound}`, plane.frame.x + plane.frame.width - 6, plane.frame.y + 6);
            return;
        }
        const stride = Math.max(1, Math.ceil((paperBound(to) - bound) / mostPaperSteps));
        const end = Math.min(this.x1.at(-1), plane.window.x1);
        const places = [[Math.max(this.x0[0], plane.window.x0), bound]];
        for (; ; bound += stride) {
            const x = this.scale.xOf(paperStep(bound - 1));
            if (!(x < end)) {
                break;
            }
            places.push([x, bound], [x, bound + stride]);
        }
        plane.line([...places, [end, bound]], "--paper", 1.5, [6, 4]);
    }

    drawGrowth(plane) {
        const lo = Math.max(this.x0[0], plane.window.x0);
        const hi = Math.min(this.x1.at(-1), plane.window.x1);
        const place = (x) => [x, growth(this.scale.q(x), this.constant)];
        plane.line(Array.from({ length: 201 }, (_, i) => place(lo + ((hi - lo) * i) / 200)), "--growth", 1.25, [2, 3]);
    }

    tell(x) {
        const i = x === null ? -1 : this.x1.findIndex((end, k) => x <= end && x >= this.x0[k]);
        if (i < 0) {
            this.readout.textContent = x === null ? hint : "Nothing is claimed here.";
            return;
        }
        const { status, lower, upper, lo_text, hi_text } = this.pieces[i];
        const range = lo_text === hi_text ? `q = ${shortened(lo_text)}` : `q from ${shortened(lo_text)} to ${shortened(hi_text)}`;
        const value = {
            exact: `N(q) = ${upper}`,
            gap: `N(q) is ${lower} ${upper - lower > 1 ? "to" : "or"} ${upper} (a gap around the step)`,
            open: `N(q) is at least ${lower}${upper === null ? "" : ` and at most ${upper}`} (open)`,
        }[status];
        const q = this.scale.q(x);
        const beside = this.isCompared ? `; the paper\u2019s bound ${paperBound(q)}, 2 + C\u221aq = ${show(growth(q, this.constant), 5)}` : "";
        this.readout.textContent = `At ${this.file.symbol} = ${this.scale.text(x)}: ${value}${beside}. Piece ${i + 1}: ${range}.`;
    }

    caption() {
        const key = (name, text) => h("span", { class: `key ${name}` }, text);
        const keys = [key("proved", "claimed maximum N(q)")];
        if (this.gaps.length > 0) {
            keys.push(key("gap", "gap: one of two values"));
        }
        if (this.pieces.some((p) => p.status === "open")) {
            keys.push(key("open", "not decided"));
        }
        if (this.isCompared) {
            keys.push(key("paper", "the paper\u2019s bound \u2308\u03c0/\u03b3\u2309 + 1, \u03b3 = 2 atan(1/\u221aq)"), key("growth", `2 + C\u221aq, C = ${show(this.constant, 7)}\u2026`));
        }
        const gaps = this.gaps.length === 0 ? "" : ` ${plural(this.gaps.length, "gap")} between the steps, drawn at least as wide as a line; choose one above to see its true width.`;
        return h("figcaption", {}, h("span", { class: "keys" }, keys), `The staircase.${gaps} Zoom with + and \u2212, move with the arrow keys or by dragging, 0 shows everything.`);
    }
}
