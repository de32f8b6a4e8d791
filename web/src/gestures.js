// How a plane's window is moved by hand.

const wheelRate = 0.0015;

const place = (plane, event) => {
    const box = plane.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
};

/// The same as a place of the plane.
const under = (plane, event) => {
    const [px, py] = place(plane, event);
    return [plane.xAt(px), plane.yAt(py)];
};

const reach = 14; // px around a handle

const isOnHandle = (plane, [px, py]) => {
    const { handle } = plane.options;
    return Boolean(handle) && Math.hypot(px - plane.X(handle.x()), py - plane.Y(handle.y())) <= reach;
};

/// Dragging moves, or takes the handle along; two fingers or a double click zoom; so does the wheel if the canvas has the focus,
/// or with Ctrl: a page that is scrolled through stays as it is.
export function moveByPointer(plane) {
    const { canvas } = plane;
    const fingers = new Map();
    let travelled = 0;
    let isHeld = false;

    canvas.addEventListener("wheel", (event) => {
        if (!event.ctrlKey && document.activeElement !== canvas) {
            return;
        }
        event.preventDefault();
        plane.zoom(Math.exp(event.deltaY * wheelRate), ...under(plane, event));
    }, { passive: false });

    canvas.addEventListener("dblclick", (event) => plane.zoom(1 / 3, ...under(plane, event)));

    canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        fingers.set(event.pointerId, place(plane, event));
        travelled = 0;
        isHeld = fingers.size === 1 && isOnHandle(plane, place(plane, event));
    });

    canvas.addEventListener("pointermove", (event) => {
        const now = place(plane, event);
        const before = fingers.get(event.pointerId);
        if (!before) {
            plane.options.probe?.(...under(plane, event));
            canvas.style.cursor = isOnHandle(plane, now) ? "grab" : "";
            return;
        }
        fingers.set(event.pointerId, now);
        travelled += Math.hypot(now[0] - before[0], now[1] - before[1]);
        if (isHeld && fingers.size === 1) {
            plane.options.handle.move(...under(plane, event));
        } else if (fingers.size === 1 && travelled > 3) {
            plane.pan((before[0] - now[0]) / plane.frame.width, (now[1] - before[1]) / plane.frame.height);
        } else if (fingers.size === 2) {
            const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
            const distance = (of) => Math.max(10, Math.hypot(of[0] - other[0], of[1] - other[1]));
            plane.zoom(distance(before) / distance(now), plane.xAt(other[0]), plane.yAt(other[1]));
        }
    });

    const lift = (event) => {
        if (fingers.delete(event.pointerId) && event.type === "pointerup" && travelled <= 3) {
            plane.options.probe?.(...under(plane, event));
            plane.options.click?.(...under(plane, event));
        }
    };
    canvas.addEventListener("pointerup", lift);
    canvas.addEventListener("pointercancel", lift);
    canvas.addEventListener("pointerleave", () => plane.options.probe?.(null, null));
}

const keys = {
    "+": (plane) => plane.zoom(0.5),
    "=": (plane) => plane.zoom(0.5),
    "-": (plane) => plane.zoom(2),
    0: (plane) => plane.reset(),
};

const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const step = 0.01; // of the window

/// After each key, what lies in the middle is told. With shift the arrows move the handle.
export function moveByKeys(plane) {
    plane.canvas.addEventListener("keydown", (event) => {
        const { x0, x1, y0, y1 } = plane.window;
        const { handle, click, probe } = plane.options;
        const [dx, dy] = arrows[event.key] ?? [0, 0];
        const isArrow = event.key in arrows;
        if (handle && event.shiftKey && isArrow) {
            event.preventDefault();
            handle.move(handle.x() + dx * step * (x1 - x0), handle.y() + dy * step * (y1 - y0));
            return;
        }
        if (event.key === "Enter") {
            click?.((x0 + x1) / 2, (y0 + y1) / 2);
            return;
        }
        const move = isArrow ? () => plane.pan(dx / 10, dy / 10) : keys[event.key];
        if (!move || event.ctrlKey || event.altKey || event.metaKey) {
            return;
        }
        event.preventDefault();
        move(plane);
        const w = plane.window;
        probe?.((w.x0 + w.x1) / 2, (w.y0 + w.y1) / 2);
    });
}
