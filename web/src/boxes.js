// Draws the boxes of a tree: as they are in its own coordinates, or where a map puts them.
import { hatching } from "./theme.js";

const finest = 0.7; // px; what is smaller is drawn as one
const outlined = 5; // px; smaller boxes have no outline

/// A map from chart coordinates to the picture's: {x(a), y(a, b)} with x monotone, y increasing in b. Null: the identity.
const edges = (map, a0, a1, b0, b1) => {
    const [xa, xb] = [map.x(a0), map.x(a1)];
    const ys = [map.y(a0, b0), map.y(a1, b0), map.y(a0, b1), map.y(a1, b1)];
    return [Math.min(xa, xb), Math.max(xa, xb), Math.min(...ys), Math.max(...ys)];
};

const identity = { x: (a) => a, y: (a, b) => b, straight: true };

/// view: {tree, xAxis, yAxis, fixed, map, paint(kind): a colour or "hatched", ink}. Returns how many boxes were drawn.
export function drawBoxes(plane, view) {
    const { tree, xAxis: X, yAxis: Y } = view;
    const map = view.map ?? identity;
    const c = plane.context;
    const w = plane.window;
    const perX = plane.frame.width / (w.x1 - w.x0);
    const perY = plane.frame.height / (w.y1 - w.y0);
    const range = (box) => edges(map, box[2 * X], box[2 * X + 1], box[2 * Y], box[2 * Y + 1]);
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
        if (map.straight || width < 2) {
            // Half a pixel more, so that neighbours leave no seam.
            c.fillRect(left, top, Math.max(finest, width + (isLarge ? 0 : 0.35)), Math.max(finest, height + (isLarge ? 0 : 0.35)));
            if (isLarge) {
                c.strokeRect(left, top, width, height);
            }
        } else {
            outline(plane, map, box, X, Y, width);
            c.fill();
            if (isLarge) {
                c.stroke();
            }
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

/// The path around a box whose sides are curves.
function outline(plane, map, box, X, Y, width) {
    const c = plane.context;
    const parts = Math.max(1, Math.min(24, Math.ceil(width / 10)));
    const at = (i) => box[2 * X] + ((box[2 * X + 1] - box[2 * X]) * i) / parts;
    c.beginPath();
    for (let i = 0; i <= parts; ++i) {
        c.lineTo(plane.X(map.x(at(i))), plane.Y(map.y(at(i), box[2 * Y])));
    }
    for (let i = parts; i >= 0; --i) {
        c.lineTo(plane.X(map.x(at(i))), plane.Y(map.y(at(i), box[2 * Y + 1])));
    }
    c.closePath();
}
