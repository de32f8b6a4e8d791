// Orbits: {q, rho, collisions: [{t, psi, y, heavy, before, after}], first, last, complete}: velocities {vpsi, vy}; `first` and `last` are the
// flights before and after the collisions, as a state {t, psi, y, vpsi, vy} on each and a time until which to show it. `isCorner`:
// it ends where both masses hit the floor at once, and no motion is defined.
import { nextContact, reflected } from "./flight.js";

export const mostCollisions = 20000; // followed

/// Heights are computed in units of beta2; this many rod lengths are that.
export const lengthUnit = ({ rho }) => 1 / (1 + rho);

const cornerRange = 1e-11; // of angles: closer to flat, doubles do not tell which mass hits first

/// How long to show a flight that leaves: until both masses are well above the floor, or the rod has turned enough.
function shownAfter({ y, vpsi, vy }) {
    const rise = vy > 0 ? Math.max(0.25, 1.35 - y) / vy : Infinity;
    const turn = vpsi !== 0 ? (1.25 * Math.PI) / Math.abs(vpsi) : Infinity;
    const until = Math.min(rise, turn);
    return Number.isFinite(until) ? until : 1;
}

const reversed = ({ vpsi, vy }) => ({ vpsi: -vpsi, vy: -vy });

/// The orbit of a dumbbell in the air: phi, phidot, y, ydot in rod lengths and radians, q >= 1.
export function orbitFromStart({ q, phi, phidot, y, ydot }) {
    const r = 1 / q;
    const state = { t: 0, psi: phi - Math.PI / 2, y: y * (1 + r), vpsi: phidot, vy: ydot * (1 + r) };
    return forward(q, state, null, { ...state, until: 0 });
}

/// Of a body with the heights rho (L70): q is its Q.
export function forward(q, state, collision, first, rho = 1 / q) {
    const collisions = collision ? [collision] : [];
    const contact = () => nextContact(state, rho, collisions.at(-1)?.heavy ?? null);
    const isAtCorner = (next) => Math.abs(Math.cos(state.psi + state.vpsi * next.after)) < cornerRange;
    let next = contact();
    for (; next && collisions.length < mostCollisions && !isAtCorner(next); next = contact()) {
        const at = { t: state.t + next.after, psi: state.psi + state.vpsi * next.after, y: state.y + state.vy * next.after };
        const before = { vpsi: state.vpsi, vy: state.vy };
        const after = reflected({ ...at, ...before }, next.heavy, 1 / q, rho);
        collisions.push({ ...at, heavy: next.heavy, before, after });
        state = { ...at, ...after };
    }
    const isCorner = next !== null && collisions.length < mostCollisions;
    const complete = next === null && !(state.vy < 0); // what falls hits the floor: doubles did not find where
    const until = state.t + (isCorner ? next.after : shownAfter(state));
    return { q, rho, collisions, first, last: { ...state, until }, complete, isCorner };
}

/// What its two ends are called: of a body with a shape they have no masses.
export const endsOf = ({ shape }) => (shape ? ["contact 1", "contact 2"] : ["light mass", "heavy mass"]);

/// What its lengths are measured in.
export const unitName = ({ shape }) => (shape ? "distances of the contacts" : "rod lengths");

/// An orbit from its middle: `rays.out` and `rays.back` are the collisions along the outgoing ray and along the reversed incoming
/// one, each with times from the middle on.
export function joined(q, middle, out, back, rho = 1 / q) {
    const past = back.map((c) => ({ ...c, t: -c.t, before: reversed(c.after), after: reversed(c.before) })).reverse();
    const all = [...past, middle, ...out];
    const zero = all[0].t;
    const collisions = all.map((c) => ({ ...c, t: c.t - zero }));
    const [a, b] = [collisions[0], collisions.at(-1)];
    const first = { t: a.t, psi: a.psi, y: a.y, ...a.before };
    const last = { t: b.t, psi: b.psi, y: b.y, ...b.after };
    return {
        q,
        rho,
        collisions,
        first: { ...first, until: first.t - shownAfter({ y: a.y, ...reversed(a.before) }) },
        last: { ...last, until: last.t + shownAfter(last) },
        complete: true,
    };
}

/// Where the point is at time t, with its velocity and the number of collisions so far.
export function stateAt(orbit, t) {
    const { collisions, first } = orbit;
    let [lo, hi] = [0, collisions.length]; // the first collision that is later than t
    while (lo < hi) {
        const middle = (lo + hi) >> 1;
        [lo, hi] = collisions[middle].t <= t ? [middle + 1, hi] : [lo, middle];
    }
    const from = lo === 0 ? first : { ...collisions[lo - 1], ...collisions[lo - 1].after };
    const dt = t - from.t;
    return { t, psi: from.psi + from.vpsi * dt, y: from.y + from.vy * dt, vpsi: from.vpsi, vy: from.vy, done: lo };
}
