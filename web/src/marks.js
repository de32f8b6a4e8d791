// Orbits marked in the picture of a cover.
import { colour } from "./theme.js";

/// marks: [{colour (CSS variable), text, points: [[position, slope], ...]}] in chart coordinates; each a chain of dots, named at
/// its first one. map as in boxes.js.
export function drawMarks(plane, marks, map) {
    const c = plane.context;
    const w = plane.window;
    for (const { colour: name, text, points } of marks) {
        const at = points.map(([a, b]) => (map ? [map.x(a), map.y(a, b)] : [a, b]));
        const pixels = at.map(([x, y]) => [plane.X(x), plane.Y(y)]);
        c.lineWidth = 1.25;
        c.strokeStyle = colour(name);
        c.setLineDash([4, 3]);
        c.beginPath();
        pixels.forEach(([x, y]) => c.lineTo(x, y));
        c.stroke();
        c.setLineDash([]);
        pixels.forEach(([x, y], i) => {
            c.beginPath();
            c.arc(x, y, i === 0 ? 5 : 3.5, 0, 2 * Math.PI);
            c.fillStyle = colour(name);
            c.fill();
            c.lineWidth = 1.5;
            c.strokeStyle = colour("--paper-white");
            c.stroke();
        });
        const first = at.findIndex(([x, y]) => x >= w.x0 && x <= w.x1 && y >= w.y0 && y <= w.y1);
        if (first >= 0) {
            label(plane, pixels[first], text, colour(name));
        }
    }
}

/// Text beside a dot, inside the frame.
function label(plane, [x, y], text, ink) {
    const c = plane.context;
    c.font = `600 12px ${colour("--font")}`;
    c.textBaseline = "middle";
    const width = c.measureText(text).width;
    const isRight = x + width + 14 < plane.frame.x + plane.frame.width;
    const top = Math.min(Math.max(y, plane.frame.y + 12), plane.frame.y + plane.frame.height - 12);
    const left = isRight ? x + 9 : x - 9 - width;
    c.fillStyle = colour("--paper-white");
    c.globalAlpha = 0.85;
    c.fillRect(left - 3, top - 9, width + 6, 18);
    c.globalAlpha = 1;
    c.textAlign = "left";
    c.fillStyle = ink;
    c.fillText(text, left, top);
}
