// What a picture draws on a canvas, as SVG text: the same calls, recorded. Only those that the pictures use.
import { colour } from "./theme.js";

const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");
const px = (x) => String(Math.round(x * 100) / 100);
const anchors = { left: "start", center: "middle", right: "end" };
const shifts = { top: "0.8em", middle: "0.35em" }; // from a text's place to its base line

export class SvgPage {
    constructor(width, height, canvas) {
        Object.assign(this, { width, height, canvas, parts: [], open: [0], dash: [], clips: 0, globalAlpha: 1 });
    }

    setTransform() {}
    clearRect() {}
    createPattern() { return "url(#hatching)"; }
    measureText(text) {
        this.canvas.font = this.font;
        return this.canvas.measureText(text);
    }
    setLineDash(dash) { this.dash = dash; }

    save() { this.open.push(0); }
    restore() { this.parts.push("</g>".repeat(this.open.pop())); }
    group(attributes) {
        this.parts.push(`<g ${attributes}>`);
        this.open.push(this.open.pop() + 1);
    }
    translate(x, y) { this.group(`transform="translate(${px(x)} ${px(y)})"`); }
    rotate(angle) { this.group(`transform="rotate(${px((angle * 180) / Math.PI)})"`); }
    clip() {
        this.parts.push(`<clipPath id="clip-${++this.clips}"><path d="${this.path}"/></clipPath>`);
        this.group(`clip-path="url(#clip-${this.clips})"`);
    }

    beginPath() { this.path = ""; }
    moveTo(x, y) { this.path += `M${px(x)} ${px(y)}`; }
    lineTo(x, y) { this.path += `${this.path === "" ? "M" : "L"}${px(x)} ${px(y)}`; }
    rect(x, y, width, height) { this.path += `M${px(x)} ${px(y)}h${px(width)}v${px(height)}h${px(-width)}z`; }
    /// Whole circles only.
    arc(x, y, radius) { this.path += `M${px(x - radius)} ${px(y)}a${px(radius)} ${px(radius)} 0 1 0 ${px(2 * radius)} 0a${px(radius)} ${px(radius)} 0 1 0 ${px(-2 * radius)} 0`; }

    get alpha() { return this.globalAlpha === 1 ? "" : ` opacity="${this.globalAlpha}"`; }
    shape(path, paint) { this.parts.push(`<path d="${path}" ${paint}${this.alpha}/>`); }
    get line() { return `fill="none" stroke="${this.strokeStyle}" stroke-width="${this.lineWidth}"${this.dash.length > 0 ? ` stroke-dasharray="${this.dash.join(" ")}"` : ""}`; }
    fill() { this.shape(this.path, `fill="${this.fillStyle}"`); }
    stroke() { this.shape(this.path, this.line); }
    boxed(draw, ...box) {
        this.beginPath();
        this.rect(...box);
        draw.call(this);
    }
    fillRect(...box) { this.boxed(this.fill, ...box); }
    strokeRect(...box) { this.boxed(this.stroke, ...box); }
    fillText(text, x, y) {
        this.parts.push(`<text x="${px(x)}" y="${px(y)}" dy="${shifts[this.textBaseline] ?? "0"}" text-anchor="${anchors[this.textAlign]}" style="font:${escaped(this.font)}" fill="${this.fillStyle}"${this.alpha}>${escaped(text)}</text>`);
    }

    /// The whole file. `space` is SVG's own.
    finished(title, space) {
        const hatching = `<pattern id="hatching" width="6" height="6" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><line x1="0" y1="0" x2="0" y2="6" stroke="${colour("--hatch")}" stroke-width="1.4"/></pattern>`;
        return `<svg xmlns="${space}" viewBox="0 0 ${this.width} ${this.height}" width="${this.width}" height="${this.height}"><title>${escaped(title)}</title><defs>${hatching}</defs><rect width="100%" height="100%" fill="${colour("--paper-white")}"/>\n${this.parts.join("\n")}\n</svg>\n`;
    }
}
