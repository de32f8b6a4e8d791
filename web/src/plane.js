// A canvas with two axes that can be zoomed and moved: by wheel (when it has the focus, or with Ctrl), by dragging, by two
// fingers, by buttons, by keys. What is drawn on it, and the marks of its axes, are its owner's.
import { h } from "./dom.js";
import { colour, onTheme } from "./theme.js";
import { linearTicks } from "./ticks.js";
import { moveByKeys, moveByPointer } from "./gestures.js";

const margin = { left: 62, right: 14, top: 12, bottom: 56 };
const slowMs = 14; // a drawing that takes longer is replaced by a stretched copy while the window moves

/// options: home {x0, x1, y0, y1}; draw(plane); title (for those who do not see it); xLabel, yLabel: text or function;
/// xTicks, yTicks: as linearTicks; probe(x, y): called with what lies under the pointer, or under the middle for keys, null when
/// the pointer leaves; click(x, y); handle {x(), y(), move(x, y)}: a place that can be dragged; height in px; least {x, y}: of a window.
export class Plane {
    constructor(options) {
        this.options = { xTicks: linearTicks, yTicks: linearTicks, height: 380, least: { x: 1e-14, y: 1e-14 }, ...options };
        this.canvas = h("canvas", { tabindex: "0", role: "img", "aria-label": options.title });
        this.canvas.style.height = `${this.options.height}px`;
        this.context = this.canvas.getContext("2d");
        this.home = { ...options.home };
        this.window = { ...options.home };
        this.element = h("div", { class: "plane" }, this.canvas, this.buttons());
        moveByPointer(this);
        moveByKeys(this);
        new ResizeObserver(() => this.draw()).observe(this.canvas);
        onTheme(() => this.draw());
    }

    buttons() {
        /// What is no word has a name for those who do not see it.
        const button = (text, title, onclick) => h("button", { type: "button", title, "aria-label": /\w/.test(text) ? null : title, onclick }, text);
        return h(
            "div",
            { class: "plane-buttons" },
            button("+", "Zoom in", () => this.zoom(0.5)),
            button("\u2212", "Zoom out", () => this.zoom(2)),
            button("Reset", "Show everything", () => this.reset()),
            button("Save", "Save this picture as a PNG file", () => this.save()),
        );
    }

    /// A new home, shown at once.
    setHome(home) {
        this.home = { ...home };
        this.reset();
    }

    reset() {
        this.window = { ...this.home };
        this.moved();
    }

    show(window) {
        this.window = { ...this.window, ...window };
        this.moved();
    }

    /// Scales the window by `factor` about (x, y), by default its middle.
    zoom(factor, x = (this.window.x0 + this.window.x1) / 2, y = (this.window.y0 + this.window.y1) / 2) {
        const w = this.window;
        const { least } = this.options;
        const fx = Math.max(factor, least.x / (w.x1 - w.x0));
        const fy = Math.max(factor, least.y / (w.y1 - w.y0));
        this.window = { x0: x + (w.x0 - x) * fx, x1: x + (w.x1 - x) * fx, y0: y + (w.y0 - y) * fy, y1: y + (w.y1 - y) * fy };
        this.moved();
    }

    /// By shares of the window.
    pan(dx, dy) {
        const w = this.window;
        const x = dx * (w.x1 - w.x0);
        const y = dy * (w.y1 - w.y0);
        this.window = { x0: w.x0 + x, x1: w.x1 + x, y0: w.y0 + y, y1: w.y1 + y };
        this.moved();
    }

    moved() {
        this.options.moved?.(this);
        if (this.cost > slowMs && this.copy) {
            this.stretch();
            clearTimeout(this.later);
            this.later = setTimeout(() => this.draw(), 80);
        } else {
            this.draw();
        }
    }

    X(x) { return this.frame.x + ((x - this.window.x0) / (this.window.x1 - this.window.x0)) * this.frame.width; }
    Y(y) { return this.frame.y + this.frame.height - ((y - this.window.y0) / (this.window.y1 - this.window.y0)) * this.frame.height; }
    xAt(px) { return this.window.x0 + ((px - this.frame.x) / this.frame.width) * (this.window.x1 - this.window.x0); }
    yAt(py) { return this.window.y0 + ((this.frame.y + this.frame.height - py) / this.frame.height) * (this.window.y1 - this.window.y0); }

    begin() {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        const scale = devicePixelRatio || 1;
        const pixels = [Math.round(width * scale), Math.round(height * scale)];
        if (this.canvas.width !== pixels[0] || this.canvas.height !== pixels[1]) {
            [this.canvas.width, this.canvas.height] = pixels;
        }
        this.context.setTransform(scale, 0, 0, scale, 0, 0);
        this.context.clearRect(0, 0, width, height);
        this.frame = { x: margin.left, y: margin.top, width: width - margin.left - margin.right, height: height - margin.top - margin.bottom };
    }

    draw() {
        if (this.canvas.clientWidth <= margin.left + margin.right + 10) {
            return; // not shown
        }
        const start = performance.now();
        this.begin();
        const { context: c, frame } = this;
        this.drawAxes();
        c.save();
        c.beginPath();
        c.rect(frame.x, frame.y, frame.width, frame.height);
        c.clip();
        this.options.draw(this);
        c.restore();
        this.cost = performance.now() - start;
        this.drawn = { ...this.window };
        if (this.cost > slowMs) {
            this.copy ??= document.createElement("canvas");
            [this.copy.width, this.copy.height] = [this.canvas.width, this.canvas.height];
            this.copy.getContext("2d").drawImage(this.canvas, 0, 0);
        }
        // For those who look from outside: where the frame is, and what it shows.
        const { x0, x1, y0, y1 } = this.window;
        Object.assign(this.canvas.dataset, { frame: JSON.stringify(frame), window: JSON.stringify({ x0, x1, y0, y1 }), ms: this.cost.toFixed(1) });
    }

    /// As it stands, as a file of the reader's.
    save() {
        const { context: c, canvas } = this;
        c.globalCompositeOperation = "destination-over";
        c.fillStyle = colour("--paper-white");
        c.fillRect(0, 0, canvas.clientWidth, canvas.clientHeight);
        h("a", { href: canvas.toDataURL(), download: `${this.options.title.replace(/[^A-Za-z0-9.]+/g, "-")}.png` }).click();
        c.globalCompositeOperation = "source-over";
        this.draw();
    }

    /// The last drawing where it would be in the present window.
    stretch() {
        this.begin();
        const { context: c, frame, drawn } = this;
        const scale = devicePixelRatio || 1;
        c.save();
        c.beginPath();
        c.rect(frame.x, frame.y, frame.width, frame.height);
        c.clip();
        c.imageSmoothingEnabled = false;
        c.drawImage(
            this.copy, frame.x * scale, frame.y * scale, frame.width * scale, frame.height * scale,
            this.X(drawn.x0), this.Y(drawn.y1), this.X(drawn.x1) - this.X(drawn.x0), this.Y(drawn.y0) - this.Y(drawn.y1),
        );
        c.restore();
        this.drawAxes();
    }

    drawAxes() {
        const { context: c, frame, window: w, options } = this;
        const label = (of) => (typeof of === "function" ? of() : of);
        c.font = `12px ${colour("--font")}`;
        c.fillStyle = colour("--soft");
        c.strokeStyle = colour("--grid");
        c.lineWidth = 1;
        c.textAlign = "center";
        c.textBaseline = "top";
        for (const { at, text } of options.xTicks(w.x0, w.x1, Math.max(2, frame.width / 95))) {
            this.rule(this.X(at), frame.y, this.X(at), frame.y + frame.height);
            c.fillText(text, this.X(at), frame.y + frame.height + 7);
        }
        c.textAlign = "right";
        c.textBaseline = "middle";
        for (const { at, text } of options.yTicks(w.y0, w.y1, frame.height / 50)) {
            this.rule(frame.x, this.Y(at), frame.x + frame.width, this.Y(at));
            c.fillText(text, frame.x - 7, this.Y(at));
        }
        c.textAlign = "center";
        c.fillText(label(options.xLabel), frame.x + frame.width / 2, frame.y + frame.height + margin.bottom - 15);
        c.save();
        c.translate(13, frame.y + frame.height / 2);
        c.rotate(-Math.PI / 2);
        c.fillText(label(options.yLabel), 0, 0);
        c.restore();
    }

    rule(x0, y0, x1, y1) {
        const half = (px) => Math.round(px) + 0.5;
        this.stroke([[half(x0), half(y0)], [half(x1), half(y1)]]);
    }

    stroke(pixels) {
        const { context: c } = this;
        c.beginPath();
        pixels.forEach((at) => c.lineTo(...at));
        c.stroke();
    }

    /// A line through places [x, y] of the picture.
    line(places, ink, width, dash = []) {
        const { context: c } = this;
        c.strokeStyle = colour(ink);
        c.lineWidth = width;
        c.setLineDash(dash);
        this.stroke(places.map(([x, y]) => [this.X(x), this.Y(y)]));
        c.setLineDash([]);
    }

    /// A dot at a place, with an edge that keeps it off what is below.
    dot(x, y, radius, ink, edge = 0) {
        const { context: c } = this;
        c.beginPath();
        c.arc(this.X(x), this.Y(y), radius, 0, 2 * Math.PI);
        c.fillStyle = colour(ink);
        c.fill();
        if (edge > 0) {
            c.lineWidth = edge;
            c.strokeStyle = colour("--paper-white");
            c.stroke();
        }
    }
}
