// Orbits marked in the picture of a cover.
import { colour } from "./theme.js";

/// marks: [{colour (CSS variable), text, points: [[position, slope], ...]}] in chart coordinates; each a chain of dots, named at
/// its first one that is in the window.
export function drawMarks(plane, marks) {
    for (const { colour: ink, points: at } of marks) {
        plane.line(at, ink, 1.25, [4, 3]);
        at.forEach(([x, y], i) => plane.dot(x, y, i === 0 ? 5 : 3.5, ink, 1.5));
    }
    const w = plane.window;
    const labels = [];
    for (const { points: at, text, colour: ink } of marks) {
        const first = at.find(([x, y]) => x >= w.x0 && x <= w.x1 && y >= w.y0 && y <= w.y1);
        if (first) {
            drawLabel(plane, [plane.X(first[0]), plane.Y(first[1])], text, colour(ink), labels);
        }
    }
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
