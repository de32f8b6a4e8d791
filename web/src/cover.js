// The boxes of a cover, with their reasons. What a file's boxes mean comes as `source`:
//   choices: [{text, tree (data), chart, explain (the verifier's path to the root), marks}]
//   first: index of the choice shown at first;  kinds;  colourings: [{text, paint(kind): a colour or "hatched", label(kind), order(kind)}]
//   describe(kind, chart): a leaf in a line;  note: text below;  file: for the verifier;  play(): plays what was simulated last
//   simulate(point): follows it, and says what it found; the picture then has a start that can be dragged
import { h, labelled, output, select } from "./dom.js";
import { drawBoxes } from "./boxes.js";
import { axisLabel, boxText, chartAbout } from "./charts.js";
import { drawMarks } from "./marks.js";
import { plural, show } from "./numbers.js";
import { Plane } from "./plane.js";
import { colour, onTheme } from "./theme.js";
import { angleTicks, linearTicks } from "./ticks.js";
import { BoxTree } from "./tree.js";

const hint = "Point at a box, or move the picture with the arrow keys: what lies in the middle is told here.";

const startHint = "Drag the dot, or move it with shift and the arrow keys: what is certified of that start is told here, beside what the page simulates.";

export class Cover {
    constructor(source) {
        this.source = source;
        this.colouring = source.colourings[0];
        this.readout = output("readout tall", hint);
        this.controls = h("div", { class: "controls" });
        this.sliders = h("div", { class: "controls" });
        this.legend = h("span", { class: "keys" });
        this.plane = new Plane({
            title: source.title,
            home: { x0: 0, x1: 1, y0: 0, y1: 1 },
            height: 440,
            xLabel: () => this.label(this.x),
            yLabel: () => this.label(this.y),
            xTicks: (...of) => (this.isAngle(this.x) ? angleTicks : linearTicks)(...of),
            yTicks: (...of) => (this.isAngle(this.y) ? angleTicks : linearTicks)(...of),
            draw: (plane) => this.draw(plane),
            moved: () => (this.outline.hidden = true),
            probe: (x, y) => this.tell(x, y),
            click: source.play && ((x, y) => this.play(x, y)),
            handle: source.simulate && { x: () => this.fixed[this.x], y: () => this.fixed[this.y], move: (x, y) => this.moveStart(x, y) },
        });
        this.start = source.simulate ? output("readout start", startHint) : null;
        this.outline = h("div", { class: "outline", hidden: true });
        this.plane.element.append(this.outline);
        this.counter = h("span", {});
        this.element = h(
            "figure",
            { class: "wide map" },
            this.controls,
            this.sliders,
            this.plane.element,
            this.readout,
            this.start,
            h("figcaption", {}, this.legend, this.counter, source.note ? h("span", {}, " ", source.note) : null),
        );
        this.choose(source.first ?? 0);
        onTheme(() => this.fillLegend());
    }

    choose(index) {
        this.choice = this.source.choices[index];
        this.index = index;
        this.choice.boxes ??= new BoxTree(this.choice.tree);
        this.tree = this.choice.boxes;
        this.wide = this.tree.axes.map((axis, a) => (axis.hi > axis.lo ? a : -1)).filter((a) => a >= 0);
        this.x = this.wide[0] ?? 0;
        this.y = this.wide[1] ?? (this.x === 0 ? 1 : 0);
        this.fixed = this.tree.axes.map(({ lo, hi }) => (lo + hi) / 2);
        this.fillControls();
        this.fit();
    }

    fillControls() {
        const { choices, colourings } = this.source;
        const controls = [];
        if (choices.length > 1) {
            controls.push(labelled("Cover", select(choices.map((c, i) => [i, c.text]), this.index, (i) => this.choose(Number(i)))));
        }
        if (!this.choice.chart && this.wide.length > 2) {
            const axes = this.wide.map((a) => [a, this.tree.axes[a].name]);
            const pick = (which) => select(axes, this[which], (value) => this.turn(which, Number(value)));
            controls.push(labelled("Across", pick("x")), labelled("Up", pick("y")));
        }
        if (colourings.length > 1) {
            const chosen = colourings.indexOf(this.colouring);
            controls.push(labelled("Colours", select(colourings.map((c, i) => [i, c.text]), chosen, (i) => {
                this.colouring = colourings[Number(i)];
                this.fillLegend();
                this.plane.draw();
            })));
        }
        this.controls.replaceChildren(...controls);
        this.fillSliders();
        this.fillLegend();
    }

    /// Another axis across or up; the two swap if it is the other one.
    turn(which, axis) {
        const other = which === "x" ? "y" : "x";
        if (this[other] === axis) {
            this[other] = this[which];
        }
        this[which] = axis;
        this.fillControls();
        this.fit();
    }

    /// One for each axis that the picture cuts through.
    fillSliders() {
        const cut = this.wide.filter((a) => a !== this.x && a !== this.y);
        this.sliders.replaceChildren(...cut.map((a) => {
            const { name, lo, hi } = this.tree.axes[a];
            const value = h("span", { class: "value" }, show(this.fixed[a]));
            const oninput = (event) => {
                this.fixed[a] = lo + (hi - lo) * (Number(event.target.value) / 1000);
                value.textContent = show(this.fixed[a]);
                this.plane.draw();
            };
            const slider = h("input", { type: "range", min: 0, max: 1000, value: Math.round((1000 * (this.fixed[a] - lo)) / (hi - lo)), "aria-label": `cut at ${name}`, oninput });
            return labelled(`cut at ${name} =`, h("span", { class: "slider" }, slider, value));
        }));
    }

    fillLegend() {
        const seen = new Map();
        const present = new Set(this.tree.nodes.filter((node) => node >= 0));
        for (const i of present) {
            const kind = this.source.kinds[i];
            const label = this.colouring.label(kind);
            seen.set(label, { paint: this.colouring.paint(kind), order: this.colouring.order?.(kind) ?? 0 });
        }
        let entries = [...seen].sort((a, b) => a[1].order - b[1].order || 0);
        const isThinned = entries.length > 14;
        if (isThinned) {
            const step = (entries.length - 1) / 11;
            entries = Array.from({ length: 12 }, (_, i) => entries[Math.round(i * step)]);
        }
        this.legend.replaceChildren(...entries.map(([label, { paint }]) => {
            const swatch = h("i", { class: paint === "hatched" ? paint : null });
            swatch.style.background = paint === "hatched" ? "" : paint;
            return h("span", { class: "swatch" }, swatch, label);
        }));
        const { leaves, shown } = this.tree;
        const thinned = leaves > shown ? `${leaves.toLocaleString("en")} boxes of the file are drawn as ${shown.toLocaleString("en")}: one with a diagonal stands for several and shows the greatest count among them.` : `${boxes(leaves)}.`;
        this.counter.textContent = [thinned, isThinned ? "The legend has some of the colours only." : "", this.choice.chart ? `Chart ${this.choice.chart}: ${chartAbout(this.choice.chart)}.` : ""].filter(Boolean).join(" ");
    }

    fit() {
        const [x, y] = [this.tree.axes[this.x], this.tree.axes[this.y]];
        const dx = (x.hi - x.lo || 1) * 0.02;
        const dy = (y.hi - y.lo || 1) * 0.02;
        this.plane.setHome({ x0: x.lo - dx, x1: x.hi + dx, y0: y.lo - dy, y1: y.hi + dy });
    }

    isAngle(axis) { return ["e", "t", "phi", "u"].includes(this.tree.axes[axis].name); }

    label(axis) {
        return this.source.axisText?.[this.tree.axes[axis].name] ?? axisLabel(this.choice.chart, this.tree.axes[axis].name);
    }

    draw(plane) {
        const fixed = this.fixed.map((x, a) => (a === this.x || a === this.y ? NaN : x));
        const paint = (i) => this.colouring.paint(this.source.kinds[i]);
        drawBoxes(plane, { tree: this.tree, xAxis: this.x, yAxis: this.y, fixed, paint, ink: colour("--box-ink") });
        if (this.choice.marks && this.x === 0 && this.y === 1) {
            drawMarks(plane, this.choice.marks(this.fixed[2]));
        }
        if (this.start) {
            plane.dot(this.fixed[this.x], this.fixed[this.y], 6, "--mark", 2);
        }
    }

    startAt(point) {
        this.fixed = point;
        this.fillSliders();
    }

    /// The start is the point through which the picture cuts.
    moveStart(x, y) {
        const within = (value, { lo, hi }) => Math.min(hi, Math.max(lo, value));
        this.fixed[this.x] = within(x, this.tree.axes[this.x]);
        this.fixed[this.y] = within(y, this.tree.axes[this.y]);
        this.plane.draw();
        const { kind, standsFor } = this.tree.find(this.fixed);
        const several = standsFor > 1 ? ` (the greatest of ${standsFor} leaves)` : "";
        this.start.replaceChildren(
            h("strong", {}, `Certified: ${this.source.describe(this.source.kinds[kind])}${several}. `),
            `Simulated, not rigorous: ${this.source.simulate(this.fixed)}`,
        );
    }

    /// The place in the tree's own coordinates.
    point(x, y) {
        const point = [...this.fixed];
        point[this.x] = x;
        point[this.y] = y;
        return point;
    }

    /// Outlines the box that is told about.
    mark(leaf) {
        this.outline.hidden = !leaf;
        if (this.outline.hidden) {
            return;
        }
        const { plane, x, y } = this;
        const { frame } = plane;
        const clip = (value, lo, size) => Math.min(lo + size, Math.max(lo, value));
        const left = clip(plane.X(leaf.box[2 * x]), frame.x, frame.width);
        const right = clip(plane.X(leaf.box[2 * x + 1]), frame.x, frame.width);
        const top = clip(plane.Y(leaf.box[2 * y + 1]), frame.y, frame.height);
        const bottom = clip(plane.Y(leaf.box[2 * y]), frame.y, frame.height);
        Object.assign(this.outline.style, { left: `${left}px`, top: `${top}px`, width: `${right - left}px`, height: `${bottom - top}px` });
    }

    tell(x, y) {
        const leaf = x === null ? null : this.tree.find(this.point(x, y));
        this.mark(leaf);
        if (!leaf) {
            this.readout.replaceChildren(x === null ? hint : "Outside of what the file covers.");
            return;
        }
        const { source, choice } = this;
        const several = leaf.standsFor > 1;
        const path = leaf.path === "" ? "" : `.${leaf.path}`;
        const extra = source.extra?.(leaf.number) ?? "";
        this.readout.replaceChildren(
            h("strong", {}, source.describe(source.kinds[leaf.kind], choice.chart)),
            several ? ` (the greatest of ${plural(leaf.standsFor, "leaf").replace("leafs", "leaves")})` : "",
            extra,
            h("br"),
            `Box: ${boxText(this.tree.axes, leaf.box)}.`,
            several ? "" : h("span", { class: "explain" }, " Its inequalities in numbers: ", h("code", {}, `dumbbell verify --explain ${choice.explain}${path} ${source.file}`)),
        );
    }

    play(x, y) {
        const leaf = this.tree.find(this.point(x, y));
        if (leaf) {
            this.fixed = this.tree.axes.map((_, a) => (leaf.box[2 * a] + leaf.box[2 * a + 1]) / 2);
            this.moveStart(this.fixed[this.x], this.fixed[this.y]);
            this.source.play();
        }
    }
}

const boxes = (n) => (n === 1 ? "One box" : `${n.toLocaleString("en")} boxes`);
