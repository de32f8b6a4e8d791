// Orbits marked in the picture of a cover.
import { colour } from "./theme.js";

/// marks: [{colour (CSS variable), text, points: [[position, slope], ...]}] in chart coordinates; each a chain of dots, named at
/// its first one that is in the window. map as in boxes.js.
export function drawMarks(plane, marks, map) {
    const chains = marks.map(({ colour: name, text, points }) => {
        const at = points.map(([a, b]) => (map ? [map.x(a), map.y(a, b)] : [a, b]));
        return { ink: colour(name), text, at, pixels: at.map(([x, y]) => [plane.X(x), plane.Y(y)]) };
    });
    for (const chain of chains) {
        drawChain(plane.context, chain);
    }
    const w = plane.window;
    const labels = [];
    for (const { at, pixels, text, ink } of chains) {
        const first = at.findIndex(([x, y]) => x >= w.x0 && x <= w.x1 && y >= w.y0 && y <= w.y1);
        if (first >= 0) {
            drawLabel(plane, pixels[first], text, ink, labels);
        }
    }
}

function drawChain(c, { pixels, ink }) {
    c.lineWidth = 1.25;
    c.strokeStyle = ink;
    c.setLineDash([4, 3]);
    c.beginPath();
    pixels.forEach(([x, y]) => c.lineTo(x, y));
    c.stroke();
    c.setLineDash([]);
    c.strokeStyle = colour("--paper-white");
    c.lineWidth = 1.5;
    pixels.forEach(([x, y], i) => {
        c.beginPath();
        c.arc(x, y, i === 0 ? 5 : 3.5, 0, 2 * Math.PI);
        c.fillStyle = ink;
        c.fill();
        c.stroke();
    });
}

const lineHeight = 20;

/// Text beside a dot, inside the frame and over no other label; `labels` are those that are there.
function drawLabel(plane, [x, y], text, ink, labels) {
    const c = plane.context;
    const { frame } = plane;
    c.font = `600 12px ${colour("--font")}`;
    c.textBaseline = "middle";
    c.textAlign = "left";
    const width = c.measureText(text).width + 6;
    const left = x + width + 10 < frame.x + frame.width ? x + 7 : x - 7 - width;
    const covers = (top) => labels.some((l) => left < l.left + l.width && l.left < left + width && Math.abs(l.top - top) < lineHeight);
    const lowest = frame.y + frame.height - 12;
    let top = Math.min(Math.max(y, frame.y + 12), lowest);
    for (let i = 1; covers(top) && i < 12; ++i) {
        top = Math.max(frame.y + 12, Math.min(lowest, y) - lineHeight * i);
    }
    labels.push({ left, width, top });
    c.fillStyle = colour("--paper-white");
    c.globalAlpha = 0.88;
    c.fillRect(left, top - 9, width, 18);
    c.globalAlpha = 1;
    c.fillStyle = ink;
    c.fillText(text, left + 3, top);
}
