// The plane of bodies, to point at: the picture of `dumbbell plot body`, with its answer and longest motion beside it.
import { h, s } from "./dom.js";
import { unpacked } from "./proof_link.js";
import { parse, toNumber } from "./rational.js";
import { onTheme } from "./theme.js";

const steps = 100; // of the arrow keys, along an axis
const near = 10; // of a marked body, in units of the picture: a coin is meant exactly
const pause = 150; // ms without a move before the place is asked about

/// An axis as its ticks are: places in the picture, and logarithms.
function axis(picture, name) {
    const isAcross = ([tick]) => tick.getAttribute(`${name}1`) === tick.getAttribute(`${name}2`);
    const ticks = [...picture.querySelectorAll("line.frame + text")].map((text) => [text.previousElementSibling, Math.log(text.textContent)]).filter(isAcross);
    const [[from, low], [to, high]] = [ticks[0], ticks.at(-1)].map(([tick, value]) => [Number(tick.getAttribute(`${name}1`)), value]);
    return {
        within: (place) => Math.min(Math.max(place, Math.min(from, to)), Math.max(from, to)),
        step: (to - from) / steps,
        valueAt: (place) => Number(Math.exp(low + ((place - from) / (to - from)) * (high - low)).toPrecision(3)),
        placeOf: (value) => from + ((Math.log(value) - low) / (high - low)) * (to - from),
    };
}

export class Bodies {
    /// ask(rho, Q) is called where somebody has pointed to.
    constructor(ask) {
        this.ask = ask;
        this.place = h("p", { class: "controls" });
        this.field = h("div", {
            class: "bodies", tabindex: 0, role: "slider", "aria-label": "The plane of bodies: left and right change \u03c1, up and down Q", "aria-valuemin": 1, "aria-valuemax": 100, "aria-valuenow": 9,
            onpointerdown: ({ pointerId }) => this.field.setPointerCapture(pointerId),
            onpointermove: (event) => event.buttons && this.point(event),
            onpointercancel: () => clearTimeout(this.timer),
            onclick: (event) => this.point(event),
            onkeydown: (event) => this.key(event),
        });
        this.answer = h("div", { class: "answer" });
        this.element = h("div", { class: "pair", hidden: true }, h("figure", {}, this.field, this.place, h("figcaption", {},
            "Point at a body, or press arrow keys: how often it can hit the floor is proved and verified here, and its longest motion plays. The picture shows this number for all bodies, as one verified certificate has it (certificates/plane.dbc.gz).")), this.answer);
    }

    async draw(packed) {
        if (this.field.shadowRoot) {
            return;
        }
        const root = this.field.attachShadow({ mode: "open" }); // its style is its own
        root.innerHTML = new TextDecoder().decode(await unpacked(packed, "gzip"));
        this.picture = root.querySelector("svg");
        this.picture.setAttribute("style", "display: block; width: 100%; height: auto");
        [this.rho, this.inertia] = ["x", "y"].map((name) => axis(this.picture, name));
        this.marked = [...this.picture.querySelectorAll("circle.body")].map((circle) => [circle.cx.baseVal.value, circle.cy.baseVal.value]);
        const cross = [["--paper-white", 6], ["--ink", 2]].map(([ink, width]) => s("path", { d: "M-16 0H16M0-16V16", style: `stroke: var(${ink}); stroke-width: ${width}` }));
        this.cross = this.picture.appendChild(s("g", {}, cross));
        this.put(this.rho.placeOf(1 / 2), this.inertia.placeOf(9));
        const dark = [...root.querySelector("style").sheet.cssRules].find(({ media }) => media);
        const colours = () => (dark.media.mediaText = document.getElementById("dark").media);
        onTheme(colours);
        colours();
    }

    put(x, y) {
        this.at = [x, y];
        this.cross.setAttribute("transform", `translate(${x} ${y})`);
        const [rho, inertia] = [this.rho.valueAt(x), this.inertia.valueAt(y)];
        this.place.textContent = `\u03c1 = ${rho}, Q = ${inertia}`;
        this.field.setAttribute("aria-valuetext", this.place.textContent);
        this.field.setAttribute("aria-valuenow", inertia);
        return [rho, inertia];
    }

    /// This place, or the marked body that is closer to it than `reach`, is asked about; of several in a row, the last.
    choose(px, py, reach) {
        const [x, y] = [this.rho.within(px), this.inertia.within(py)];
        const values = this.put(...(this.marked.find(([mx, my]) => Math.hypot(x - mx, y - my) < reach) ?? [x, y]));
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.ask(...values), pause);
    }

    point({ clientX, clientY }) {
        const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(this.picture.getScreenCTM().inverse());
        this.choose(x, y, near);
    }

    key(event) {
        const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
        if ((dx || dy) && !event.ctrlKey && !event.altKey && !event.metaKey) {
            event.preventDefault();
            this.choose(this.at[0] + dx * this.rho.step, this.at[1] + dy * this.inertia.step, Math.abs(this.inertia.step) / 2);
        }
    }

    /// What the page shows of one body, from its heading to its motion, comes beside the picture; it goes back where that is hidden.
    take(file, section) {
        this.answer.replaceChildren();
        if (!this.element.hidden && file?.rho && file.lo_text === file.hi_text) {
            this.put(this.rho.placeOf(toNumber(parse(file.rho))), this.inertia.placeOf(toNumber(parse(file.pieces[0].lo))));
            const parts = [...section.children];
            this.answer.append(...parts.slice(0, 1 + parts.findIndex((part) => part.querySelector(".player"))));
        }
    }
}
