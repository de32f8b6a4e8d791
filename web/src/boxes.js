// Draws the boxes of a tree.
import { hatching } from "./theme.js";

const finest = 0.7; // px; what is smaller is drawn as one
const outlined = 5; // px; smaller boxes have no outline

/// view: {tree, xAxis, yAxis, fixed, paint(kind): a colour or "hatched", ink}. Returns how many boxes were drawn.
export function drawBoxes(plane, view) {
    const { tree, xAxis: X, yAxis: Y } = view;
    const c = plane.context;
    const w = plane.window;
    const perX = plane.frame.width / (w.x1 - w.x0);
    const perY = plane.frame.height / (w.y1 - w.y0);
    const range = (box) => [box[2 * X], box[2 * X + 1], box[2 * Y], box[2 * Y + 1]];
    const colours = new Map();
    const fill = (name) => (name === "hatched" ? hatching(c) : name);
    const paint = (kind) => colours.get(kind) ?? colours.set(kind, fill(view.paint(kind))).get(kind);
    let drawn = 0;

    const skip = (box) => {
        const [x0, x1, y0, y1] = range(box);
        return x1 < w.x0 || x0 > w.x1 || y1 < w.y0 || y0 > w.y1;
    };
    const small = (box) => {
        const [x0, x1, y0, y1] = range(box);
        return (x1 - x0) * perX < finest && (y1 - y0) * perY < finest;
    };
    c.lineWidth = 0.75;
    c.strokeStyle = view.ink;
    tree.walk(view.fixed, skip, small, (box, kind, number, isLeaf) => {
        ++drawn;
        c.fillStyle = paint(kind);
        const [x0, x1, y0, y1] = range(box);
        const left = plane.X(x0);
        const top = plane.Y(y1);
        const width = plane.X(x1) - left;
        const height = plane.Y(y0) - top;
        const isLarge = width > outlined && height > outlined;
        // Half a pixel more, so that neighbours leave no seam.
        c.fillRect(left, top, Math.max(finest, width + (isLarge ? 0 : 0.35)), Math.max(finest, height + (isLarge ? 0 : 0.35)));
        if (isLarge) {
            c.strokeRect(left, top, width, height);
        }
        if (isLarge && (tree.standsFor[number] ?? 1) > 1 && isLeaf) {
            c.beginPath();
            c.moveTo(left, top + height);
            c.lineTo(left + width, top);
            c.stroke();
        }
    });
    return drawn;
}
