// The same motion as a point (psi, y) above the floor curve: it flies straight and is reflected.
import { floorAt } from "./flight.js";
import { lengthUnit, unitName } from "./orbit.js";
import { Plane } from "./plane.js";
import { colour } from "./theme.js";
import { angleTicks } from "./ticks.js";

const mostNumbers = 60; // of collisions, written beside their dots, where there is room

export class PhaseView {
    constructor() {
        this.plane = new Plane({
            title: "The point (psi, y) above the floor curve, with the orbit's collisions",
            home: { x0: -4, x1: 4, y0: -0.1, y1: 1.4 },
            height: 340,
            xLabel: "\u03c8 = \u03c6 \u2212 \u03c0/2: angle from upright",
            yLabel: () => `y: height (${unitName(this.orbit ?? {})})`,
            xTicks: angleTicks,
            draw: (plane) => this.draw(plane),
        });
        this.element = this.plane.element;
    }

    /// `other`: one that is drawn faintly beside it, in the same units.
    setOrbit(orbit, other = null) {
        this.orbit = orbit;
        this.other = other;
        this.unit = lengthUnit(orbit);
        const ends = [at(orbit.first), at(orbit.last)];
        const points = [...orbit.collisions, ...ends];
        const psi = points.map((p) => p.psi);
        const y = points.map((p) => p.y * this.unit);
        const half = Math.PI * 1.08;
        this.state = null;
        this.plane.setHome({
            x0: Math.min(-half, ...bounded(psi, Math.min)),
            x1: Math.max(half, ...bounded(psi, Math.max)),
            y0: -0.14 * this.unit,
            y1: Math.max(1.2 * this.unit, bounded(y, Math.max)[0] * 1.04),
        });
    }

    show(state) {
        this.state = state;
        this.plane.draw();
    }

    draw(plane) {
        if (!this.orbit) {
            return;
        }
        this.drawFloor(plane);
        if (this.other) {
            plane.line(this.places(this.other), "--faint", 1.25);
        }
        this.drawPath(plane);
        this.drawCollisions(plane);
        if (this.state) {
            plane.dot(this.state.psi, this.state.y * this.unit, 6, "--point", 2);
        }
    }

    floor(psi) {
        return floorAt(psi, this.orbit.rho) * this.unit;
    }

    drawFloor(plane) {
        const c = plane.context;
        const { frame } = plane;
        const parts = Math.ceil(frame.width / 2);
        const psiAt = (i) => plane.window.x0 + ((plane.window.x1 - plane.window.x0) * i) / parts;
        const place = (i) => [psiAt(i), this.floor(psiAt(i))];
        c.fillStyle = colour("--floor");
        c.beginPath();
        c.moveTo(frame.x, frame.y + frame.height + 5);
        for (let i = 0; i <= parts; ++i) {
            const [psi, y] = place(i);
            c.lineTo(plane.X(psi), plane.Y(y));
        }
        c.lineTo(frame.x + frame.width, frame.y + frame.height + 5);
        c.fill();
        let wall = [place(0)];
        for (let i = 0; i < parts; ++i) {
            wall.push(place(i + 1));
            const [here, next] = [psiAt(i + 0.5), psiAt(i + 1.5)].map((psi) => Math.cos(psi) > 0);
            if (here !== next || i === parts - 1) {
                plane.line(wall, here ? "--heavy" : "--light", 2);
                wall = [place(i + 1)];
            }
        }
    }

    places({ collisions, first, last }) {
        return [at(first), ...collisions, at(last)].map((p) => [p.psi, p.y * this.unit]);
    }

    drawPath(plane) {
        const done = this.state?.done ?? this.orbit.collisions.length + 1;
        const places = this.places(this.orbit);
        plane.line(places.slice(done), "--faint", 1.25);
        plane.line(places.slice(0, done + 1), "--ink", 1.25);
    }

    drawCollisions(plane) {
        const c = plane.context;
        const { collisions } = this.orbit;
        c.font = `11px ${colour("--font")}`;
        c.textAlign = "center";
        c.textBaseline = "middle";
        const middle = collisions.findIndex(({ heavy }) => heavy);
        const written = [];
        const hasRoom = (px, py) => written.every(([a, b]) => Math.abs(a - px) > 13 || Math.abs(b - py) > 10);
        collisions.forEach(({ psi, y, heavy }, i) => {
            const [x, py] = [plane.X(psi), plane.Y(y * this.unit)];
            plane.dot(psi, y * this.unit, 3.2, heavy ? "--heavy" : "--light");
            if (collisions.length <= mostNumbers) {
                c.fillStyle = colour("--soft");
                const row = py + (i < middle ? -12 : 12); // the way down above, the way up below
                if (hasRoom(x, row)) {
                    c.fillText(String(i + 1), x, row);
                    written.push([x, row]);
                }
            }
        });
    }
}

/// The far end of the first or last flight that is shown.
const at = ({ t, psi, y, vpsi, vy, until }) => ({ psi: psi + vpsi * (until - t), y: y + vy * (until - t) });

const bounded = (values, pick) => [values.reduce((a, b) => pick(a, b))];
