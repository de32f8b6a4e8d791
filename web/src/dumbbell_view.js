// The dumbbell itself: rod, two masses, floor. The centre of mass moves to and fro with nothing: its uniform horizontal motion is
// left out.
import { h } from "./dom.js";
import { colour, onTheme } from "./theme.js";

const trailParts = 60;
const least = 5.5; // px, radius of the light mass

export class DumbbellView {
    constructor() {
        this.canvas = h("canvas", { class: "dumbbell", role: "img", "aria-label": "The dumbbell above the floor" });
        new ResizeObserver(() => this.state && this.draw()).observe(this.canvas);
        onTheme(() => this.state && this.draw());
    }

    /// height: what the picture must hold, in rod lengths; at(t): the state at another time, for the trail.
    setOrbit(orbit, height, at) {
        this.r = orbit.r;
        this.height = height;
        this.at = at;
    }

    show(state, hit) {
        this.state = state;
        this.hit = hit;
        this.draw();
    }

    draw() {
        const { canvas, r } = this;
        const c = canvas.getContext("2d");
        const { clientWidth: width, clientHeight: height } = canvas;
        const scale = devicePixelRatio || 1;
        [canvas.width, canvas.height] = [Math.round(width * scale), Math.round(height * scale)];
        c.setTransform(scale, 0, 0, scale, 0, 0);
        const floor = height - 34;
        const unit = Math.min((floor - 14) / this.height, width / 2.3);
        const beta2 = 1 / (1 + r);
        const places = ({ psi, y }) => {
            const centre = y * beta2;
            // phi = psi + pi/2: sin phi = cos psi, cos phi = -sin psi
            const [across, up] = [-Math.sin(psi), Math.cos(psi)];
            const place = (share) => [width / 2 + unit * share * across, floor - unit * (centre + share * up)];
            return { light: place(beta2), heavy: place(-r * beta2), centre: [width / 2, floor - unit * centre] };
        };
        this.drawFloor(c, width, height, floor);
        this.drawTrail(c, places);
        const { light, heavy, centre } = places(this.state);
        const size = (q) => least * Math.min(3.2, q ** 0.28);
        c.lineCap = "round";
        c.lineWidth = 3;
        c.strokeStyle = colour("--ink");
        line(c, light, heavy);
        dot(c, heavy, size(1 / r), colour("--heavy"));
        dot(c, light, size(1), colour("--light"));
        dot(c, centre, 1.8, colour("--paper-white"));
        if (this.hit) {
            const [x] = this.hit.heavy ? heavy : light;
            c.strokeStyle = colour(this.hit.heavy ? "--heavy" : "--light");
            c.lineWidth = 2;
            c.beginPath();
            c.ellipse(x, floor, 22, 6, 0, 0, 2 * Math.PI);
            c.stroke();
        }
    }

    drawFloor(c, width, height, floor) {
        c.fillStyle = colour("--floor");
        c.fillRect(0, floor, width, height - floor);
        c.strokeStyle = colour("--ink");
        c.lineWidth = 1.5;
        line(c, [0, floor], [width, floor]);
        c.font = `12px ${colour("--font")}`;
        c.textBaseline = "middle";
        c.textAlign = "left";
        const y = floor + (height - floor) / 2;
        dot(c, [14, y], 5, colour("--light"));
        dot(c, [112, y], 7, colour("--heavy"));
        c.fillStyle = colour("--soft");
        c.fillText("light mass", 24, y);
        c.fillText("heavy mass", 124, y);
    }

    /// Where the masses were lately.
    drawTrail(c, places) {
        const length = 2.2;
        for (const mass of ["light", "heavy"]) {
            c.strokeStyle = colour(`--${mass}`);
            c.lineWidth = 1.5;
            let before = null;
            for (let i = 0; i <= trailParts; ++i) {
                const state = this.at(this.state.t - (length * (trailParts - i)) / trailParts);
                const here = state && places(state)[mass];
                if (before && here) {
                    c.globalAlpha = 0.55 * (i / trailParts) ** 2;
                    line(c, before, here);
                }
                before = here;
            }
        }
        c.globalAlpha = 1;
    }
}

function line(c, [x0, y0], [x1, y1]) {
    c.beginPath();
    c.moveTo(x0, y0);
    c.lineTo(x1, y1);
    c.stroke();
}

function dot(c, [x, y], radius, ink) {
    c.fillStyle = ink;
    c.beginPath();
    c.arc(x, y, radius, 0, 2 * Math.PI);
    c.fill();
}
