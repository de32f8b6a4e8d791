// The dumbbell itself: rod, two masses, floor; or a body, with its two contacts: a disc or a ring, seen aslant, or a rod. The centre of mass moves to and fro with nothing: its uniform horizontal motion is
// left out. Lengths are rod lengths, upwards negative; a mass is a dot as wide as its line.
import { h, s } from "./dom.js";
import { endsOf } from "./orbit.js";

const trailParts = 60;
const trailTime = 2.2;
const across = 2.3; // rod lengths that the picture holds at least
const least = 11; // px, diameter of the light mass

const dot = (kind, width) => s("line", { class: kind, "stroke-width": width });

const place = (line, [x1, y1], [x2, y2] = [x1, y1]) => Object.entries({ x1, y1, x2, y2 }).forEach(([name, value]) => line.setAttribute(name, value));

export class DumbbellView {
    constructor() {
        const trail = (mass) => Array.from({ length: trailParts }, (_, i) => s("line", { class: mass, "stroke-width": 1.5, opacity: 0.55 * ((i + 1) / trailParts) ** 2 }));
        this.trails = { light: trail("light"), heavy: trail("heavy") };
        this.rod = s("line", { class: "rod", "stroke-width": 3 });
        this.masses = { heavy: dot("heavy", least), light: dot("light", least) };
        this.centre = dot("centre", 3.6);
        this.disc = s("ellipse", { class: "disc", rx: 0.5, ry: 0.13, "stroke-width": 2 });
        this.mark = s("ellipse", { rx: 0.16, ry: 0.045, "stroke-width": 2 });
        this.picture = s("svg", { role: "img", "aria-label": "The dumbbell above the floor" }, ...this.trails.light, ...this.trails.heavy, this.disc, this.rod, this.masses.heavy, this.masses.light, this.centre, this.mark);
        this.keys = ["light", "heavy"].map((mass) => h("span", { class: `mass ${mass}` }));
        this.element = h("div", { class: "dumbbell" }, this.picture, h("p", { class: "floor" }, this.keys));
    }

    /// height: what the picture must hold, in rod lengths; at(t): the state at another time, for the trail, which begins with the
    /// orbit.
    setOrbit(orbit, height, at) {
        this.rho = orbit.rho;
        this.at = at;
        this.picture.setAttribute("viewBox", `${-across / 2} ${-height} ${across} ${height}`);
        const { shape } = orbit;
        this.masses.heavy.setAttribute("stroke-width", shape ? least : least * Math.min(3.2, orbit.rho ** -0.28));
        this.rod.setAttribute("stroke-width", shape === "rod" ? 8 : 3);
        this.rod.classList.toggle("none", shape === "disc" || shape === "ring");
        this.disc.setAttribute("class", shape === "disc" || shape === "ring" ? shape : "none");
        this.keys.forEach((key, i) => (key.textContent = endsOf(orbit)[i]));
    }

    /// Where the masses and their centre are.
    places({ psi, y }) {
        const beta2 = 1 / (1 + this.rho);
        // phi = psi + pi/2: sin phi = cos psi, cos phi = -sin psi
        const at = (share) => [-share * Math.sin(psi), -y * beta2 - share * Math.cos(psi)];
        return { light: at(beta2), heavy: at(-this.rho * beta2), centre: at(0) };
    }

    show(state, hit) {
        const { light, heavy, centre } = this.places(state);
        place(this.rod, light, heavy);
        place(this.masses.light, light);
        place(this.masses.heavy, heavy);
        place(this.centre, centre);
        this.disc.setAttribute("transform", `translate(${centre}) rotate(${90 + (state.psi * -180) / Math.PI})`);
        this.mark.setAttribute("class", hit ? (hit.heavy ? "heavy" : "light") : "none");
        this.mark.setAttribute("cx", hit?.heavy ? heavy[0] : light[0]);
        this.showTrail(state);
    }

    /// Where the masses were lately.
    showTrail({ t }) {
        let before = null;
        for (let i = 0; i <= trailParts; ++i) {
            const here = this.places(this.at(t - (trailTime * (trailParts - i)) / trailParts));
            if (before) {
                place(this.trails.light[i - 1], before.light, here.light);
                place(this.trails.heavy[i - 1], before.heavy, here.heavy);
            }
            before = here;
        }
    }
}
