// Light and dark. The page's colours live in style.css and dark.css, those of the pictures come with the data; canvases read
// them here and are drawn again when they change.

const drawers = new Set();
const asTheSystem = "(prefers-color-scheme: dark)";
const mediaOfDark = { auto: asTheSystem, light: "not all", dark: "all" };
let chosen = "auto";

/// The value of a CSS variable, e.g. colour("--ink").
export const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/// Of a pair, as the data have it, the colour on a page as light or as dark as this one is now.
export const shade = (pair) => pair[matchMedia(document.getElementById("dark").media).matches ? 1 : 0];

/// The colours of the pictures, {name: pair}, as CSS variables; the first ones that come.
export function useColours(colours) {
    if (colour("--proved") !== "") {
        return;
    }
    ["light", "dark"].forEach((id, i) => {
        const rules = Object.entries(colours).map(([name, pair]) => `--${name}:${pair[i]}`);
        document.getElementById(id).append(`:root{${rules.join(";")}}`);
    });
    redrawAll();
}

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
export const onTheme = (draw) => drawers.add(draw);

const redrawAll = () => drawers.forEach((draw) => draw());

function show(name) {
    document.getElementById("dark").media = mediaOfDark[name];
    redrawAll();
}

/// "auto", "light" or "dark"
export function setTheme(name) {
    chosen = name;
    show(chosen);
}

export function watchTheme() {
    matchMedia(asTheSystem).addEventListener("change", redrawAll);
    // Paper is white, and nothing can be unfolded on it.
    addEventListener("beforeprint", () => {
        show("light");
        document.querySelectorAll("details:not([open])").forEach((details) => (details.open = details.classList.toggle("closed")));
    });
    addEventListener("afterprint", () => {
        show(chosen);
        document.querySelectorAll("details.closed").forEach((details) => (details.open = details.classList.toggle("closed")));
    });
}
