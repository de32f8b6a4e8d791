// An orbit, collision by collision: the dumbbell and its point, with play, step, scrub and speed. With
// `prefers-reduced-motion` nothing glides: play goes from collision to collision.
import { Clock } from "./clock.js";
import { h, labelled, output, select, table } from "./dom.js";
import { DumbbellView } from "./dumbbell_view.js";
import { grazingSine } from "./flight.js";
import { show } from "./numbers.js";
import { endsOf, lengthUnit, stateAt, unitName } from "./orbit.js";
import { PhaseView } from "./phase_view.js";

const reduced = matchMedia("(prefers-reduced-motion: reduce)");
const stepSeconds = 1.2; // per collision, where motion is reduced
const hitRange = 0.06; // of a flight, near a collision: the floor is marked
const mostRows = 400;
const mostFlights = 30; // played without being asked

export class Player {
    constructor() {
        this.speed = 1;
        this.dumbbell = new DumbbellView();
        this.phase = new PhaseView();
        this.status = output("readout tall");
        this.position = h("input", { type: "range", min: 0, step: 0.001, class: "scrub", "aria-label": "Position in the orbit", oninput: () => this.scrub() });
        this.playButton = this.button("Play", () => this.toggle());
        this.rows = h("div", {});
        this.summary = h("summary", {});
        this.details = h("details", { ontoggle: () => this.fillRows() }, this.summary, this.rows);
        this.element = h(
            "div",
            { class: "player", onkeydown: (event) => this.key(event) },
            h("div", { class: "views" }, this.dumbbell.element, this.phase.element),
            h(
                "div",
                { class: "controls transport" },
                this.button("Start", () => this.goto(0)),
                this.button("\u25c0 Step", () => this.step(-1)),
                this.playButton,
                this.button("Step \u25b6", () => this.step(1)),
                this.position,
                labelled("Speed", select([[0.25, "\u00bc"], [0.5, "\u00bd"], [1, "1"], [2, "2"], [5, "5"], [20, "20"]], 1, (value) => (this.speed = Number(value)))),
            ),
            this.status,
            this.details,
        );
    }

    button(text, onclick) {
        return h("button", { type: "button", onclick }, text);
    }

    load(orbit) {
        this.stop();
        this.orbit = orbit;
        this.clock = new Clock(orbit);
        const top = Math.max(orbit.first.until < orbit.first.t || orbit.collisions.length === 0 ? stateAt(orbit, this.clock.times[0]).y : orbit.first.y, 0);
        const from = this.clock.times[0];
        this.dumbbell.setOrbit(orbit, Math.min(6, Math.max(2.1, top / (1 + orbit.rho) + 1.08)), (t) => stateAt(orbit, Math.max(from, t)));
        this.phase.setOrbit(orbit);
        this.summary.textContent = `Every collision in numbers (doubles; heights in ${unitName(orbit)})`;
        this.position.max = this.clock.flights;
        this.rows.replaceChildren();
        this.goto(0);
        this.fillRows();
    }

    goto(p) {
        this.p = Math.min(this.clock.flights, Math.max(0, p));
        this.position.value = this.p;
        const whole = Math.round(this.p);
        const { collisions } = this.orbit;
        const hit = Math.abs(this.p - whole) < hitRange ? (collisions[whole - 1] ?? null) : null;
        const isAt = hit !== null && Math.abs(this.p - whole) < 1e-9;
        const time = isAt ? hit.t : this.clock.time(this.p);
        const state = stateAt(this.orbit, time);
        this.dumbbell.show(state, hit);
        this.phase.show(state);
        this.tell(state, isAt ? hit : null);
    }

    tell(state, hit) {
        const { collisions, q, rho, complete, isCorner } = this.orbit;
        const unit = lengthUnit(this.orbit);
        const n = `${collisions.length}${complete ? "" : " or more"}`;
        const all = `${n} ${collisions.length === 1 ? "collision" : "collisions"}`;
        const end = complete ? "it never hits the floor again" : isCorner ? "both masses hit the floor at once, and no motion is defined" : "it is not followed any further";
        const words = hit
            ? `Collision ${state.done} of ${n}, of ${this.orbit.shape ? "" : "the "}${endsOf(this.orbit)[hit.heavy ? 1 : 0]}`
            : state.done === 0
              ? collisions.length === 0 ? `${complete ? "It never hits the floor" : `Before any collision: ${end}`}` : `Before the first of ${all}`
              : state.done === collisions.length
                ? `After ${collisions.length === 1 ? "the only collision" : `all ${all}`}: ${end}`
                : `Between collisions ${state.done} and ${state.done + 1} of ${n}`;
        const numbers = hit
            ? `velocities (\u03c8, y) ${show(hit.before.vpsi, 4)}, ${show(hit.before.vy * unit, 4)} before and ${show(hit.after.vpsi, 4)}, ${show(hit.after.vy * unit, 4)} after; grazing sine ${show(grazingSine({ ...hit, ...hit.before }, hit.heavy, 1 / q, rho), 3)}`
            : `velocity (\u03c8, y) ${show(state.vpsi, 4)}, ${show(state.vy * unit, 4)}`;
        this.status.textContent = `${words}. Time ${show(state.t, 5)}, \u03c8 = ${show(state.psi, 5)}, y = ${show(state.y * unit, 5)} ${unitName(this.orbit)}; ${numbers}.`;
    }

    scrub() {
        this.stop();
        this.goto(Number(this.position.value));
    }

    step(by) {
        this.stop();
        const next = by > 0 ? Math.floor(this.p + 1e-9) + 1 : Math.ceil(this.p - 1e-9) - 1;
        this.goto(next);
    }

    toggle() {
        if (this.isPlaying) {
            this.stop();
            return;
        }
        if (this.p >= this.clock.flights) {
            this.goto(0);
        }
        this.isPlaying = true;
        this.status.setAttribute("aria-live", "off"); // not every frame
        this.playButton.textContent = "Pause";
        this.before = performance.now();
        this.waited = 0;
        this.frame = requestAnimationFrame((now) => this.tick(now));
    }

    /// When the page opens: an orbit that is short enough to be watched, if motion is wanted.
    playOnce() {
        if (this.clock.flights <= mostFlights && !reduced.matches) {
            this.toggle();
        }
    }

    stop() {
        this.isPlaying = false;
        this.status.setAttribute("aria-live", "polite");
        this.playButton.textContent = "Play";
        cancelAnimationFrame(this.frame);
    }

    tick(now) {
        const seconds = (Math.min(100, Math.max(0, now - this.before)) / 1000) * this.speed;
        this.before = now;
        if (reduced.matches) {
            this.waited += seconds;
            if (this.waited >= stepSeconds) {
                this.waited = 0;
                this.goto(Math.floor(this.p + 1e-9) + 1);
            }
        } else {
            this.goto(this.clock.later(this.p, seconds));
        }
        if (this.p >= this.clock.flights) {
            this.stop();
        } else if (this.isPlaying) {
            this.frame = requestAnimationFrame((next) => this.tick(next));
        }
    }

    /// Space plays, "," and "." step, wherever the focus is in the player, but where keys have a meaning of their own.
    key(event) {
        const tag = event.target.tagName;
        if (event.ctrlKey || event.altKey || event.metaKey || tag === "SELECT" || (tag === "INPUT" && event.target.type !== "range")) {
            return;
        }
        if (event.key === " " && tag !== "BUTTON" && tag !== "SUMMARY") {
            event.preventDefault();
            this.toggle();
        } else if (event.key === "," || event.key === ".") {
            this.step(event.key === "." ? 1 : -1);
        }
    }

    fillRows() {
        if (!this.details.open || this.rows.childElementCount > 0) {
            return;
        }
        const { collisions, q, rho } = this.orbit;
        const unit = lengthUnit(this.orbit);
        const rows = collisions.slice(0, mostRows).map((c, i) => [
            i + 1, endsOf(this.orbit)[c.heavy ? 1 : 0], show(c.t), show(c.psi), show(c.y * unit), show(c.before.vpsi), show(c.before.vy * unit), show(c.after.vpsi), show(c.after.vy * unit),
            show(grazingSine({ ...c, ...c.before }, c.heavy, 1 / q, rho), 3),
        ].map(String));
        const head = ["#", "end", "time", "\u03c8", "y", "\u03c8\u2032 before", "y\u2032 before", "\u03c8\u2032 after", "y\u2032 after", "grazing sine"];
        const caption = collisions.length > mostRows ? `The first ${mostRows} of ${collisions.length} collisions` : "Collisions";
        this.rows.replaceChildren(table(caption, head, rows, [0, 2, 3, 4, 5, 6, 7, 8, 9]));
    }
}
