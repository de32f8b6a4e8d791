// Light and dark. The colours live in style.css; canvases read them here and are drawn again when they change.

const drawers = new Set();
const system = matchMedia("(prefers-color-scheme: dark)");

/// The value of a CSS variable, e.g. colour("--ink").
export const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/// Stripes for what is not decided, as a fill.
export function hatching(context) {
    const tile = document.createElement("canvas");
    tile.width = tile.height = 6;
    const c = tile.getContext("2d");
    c.strokeStyle = colour("--hatch");
    c.lineWidth = 1.4;
    for (const shift of [-6, 0, 6]) { // the corners' parts, too
        c.beginPath();
        c.moveTo(shift - 1, 7);
        c.lineTo(shift + 7, -1);
        c.stroke();
    }
    return context.createPattern(tile, "repeat");
}

/// draw() is called whenever colours change.
export function onTheme(draw) {
    drawers.add(draw);
}

export function redrawAll() {
    for (const draw of drawers) {
        draw();
    }
}

/// "auto", "light" or "dark"
export function setTheme(name) {
    if (name === "auto") {
        delete document.documentElement.dataset.theme;
    } else {
        document.documentElement.dataset.theme = name;
    }
    redrawAll();
}

let before;

export function watchTheme() {
    system.addEventListener("change", redrawAll);
    // Paper is white.
    addEventListener("beforeprint", () => {
        before = document.documentElement.dataset.theme ?? "auto";
        setTheme("light");
    });
    addEventListener("afterprint", () => setTheme(before));
}
