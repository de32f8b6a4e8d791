// The same motion as a point (psi, y) above the floor curve: it flies straight and is reflected.
import { floorAt } from "./flight.js";
import { lengthUnit } from "./orbit.js";
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
            yLabel: () => (this.orbit?.scene === "wedge" ? "height" : "y: height (rod lengths)"),
            xTicks: angleTicks,
            draw: (plane) => this.draw(plane),
        });
        this.element = this.plane.element;
    }

    setOrbit(orbit) {
        this.orbit = orbit;
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
        this.drawPath(plane);
        this.drawCollisions(plane);
        if (this.state) {
            const c = plane.context;
            c.beginPath();
            c.arc(plane.X(this.state.psi), plane.Y(this.state.y * this.unit), 6, 0, 2 * Math.PI);
            c.fillStyle = colour("--point");
            c.fill();
            c.lineWidth = 2;
            c.strokeStyle = colour("--paper-white");
            c.stroke();
        }
    }

    floor(psi) {
        return this.orbit.scene === "wedge" ? Math.abs(psi) - Math.PI / 2 : floorAt(psi, this.orbit.r) * this.unit;
    }

    isHeavy(psi) {
        return this.orbit.scene !== "wedge" && Math.cos(psi) > 0;
    }

    drawFloor(plane) {
        const c = plane.context;
        const { frame } = plane;
        const parts = Math.ceil(frame.width / 2);
        const psiAt = (i) => plane.window.x0 + ((plane.window.x1 - plane.window.x0) * i) / parts;
        c.fillStyle = colour("--floor");
        c.beginPath();
        c.moveTo(frame.x, frame.y + frame.height + 5);
        for (let i = 0; i <= parts; ++i) {
            c.lineTo(plane.X(psiAt(i)), plane.Y(this.floor(psiAt(i))));
        }
        c.lineTo(frame.x + frame.width, frame.y + frame.height + 5);
        c.fill();
        c.lineWidth = 2;
        for (let i = 0; i < parts; ++i) {
            const [a, b] = [psiAt(i), psiAt(i + 1)];
            c.strokeStyle = colour(this.isHeavy((a + b) / 2) ? "--heavy" : "--light");
            c.beginPath();
            c.moveTo(plane.X(a), plane.Y(this.floor(a)));
            c.lineTo(plane.X(b), plane.Y(this.floor(b)));
            c.stroke();
        }
    }

    drawPath(plane) {
        const c = plane.context;
        const { collisions, first, last } = this.orbit;
        const done = this.state?.done ?? collisions.length + 1;
        const points = [at(first), ...collisions, at(last)].map((p) => [plane.X(p.psi), plane.Y(p.y * this.unit)]);
        c.lineWidth = 1.25;
        for (let i = 0; i + 1 < points.length; ++i) {
            c.strokeStyle = colour(i < done ? "--ink" : "--faint");
            c.beginPath();
            c.moveTo(...points[i]);
            c.lineTo(...points[i + 1]);
            c.stroke();
        }
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
            c.beginPath();
            c.arc(x, py, 3.2, 0, 2 * Math.PI);
            c.fillStyle = colour(heavy ? "--heavy" : "--light");
            c.fill();
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
