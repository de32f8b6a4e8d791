// The orbit of a certificate's witness, and the two extremal orbits: rays that go from wall to wall by lemma L4. The start and the
// numbers of collisions are the certificate's; what is between is computed here in doubles, as an illustration.
import { reflected } from "./flight.js";
import { forward, joined, mostCollisions } from "./orbit.js";

/// |dpsi/dt| on a flight of slope kappa, in the unit of time in which psi'^2 + q y'^2 = 1.
const speed = (kappa, r) => 1 / Math.sqrt(1 + (kappa * kappa) / r);

/// The least root of sin x = c + kappa x in [0, pi/2], or null: Newton from the left, where the difference is concave.
export function leastContact(c, kappa) {
    const peak = Math.acos(Math.max(-1, Math.min(1, kappa)));
    const top = Math.min(peak, Math.PI / 2);
    if (!(Math.sin(top) > c + kappa * top)) {
        return null;
    }
    let x = 0;
    for (let i = 0; i < 200; ++i) {
        const step = (Math.sin(x) - c - kappa * x) / (Math.cos(x) - kappa);
        const next = x - step;
        if (!(next > x)) {
            break;
        }
        x = Math.min(next, top);
    }
    return x;
}

/// The light wall's collisions of the ray that crosses the corner at height c with slope kappa, going to the side `direction`
/// (+1 right), having started `run` before that corner.
export function follow(c, kappa, r, direction, run) {
    const collisions = [];
    let t = 0;
    while (kappa < 1 && collisions.length < mostCollisions) {
        const x = leastContact(c, kappa);
        if (x === null) {
            break;
        }
        const v = speed(kappa, r);
        t += (run + x) / v;
        const at = { psi: direction * (Math.PI / 2 + x), y: Math.sin(x) };
        const before = { vpsi: direction * v, vy: kappa * v };
        collisions.push({ t, ...at, heavy: false, before, after: reflected({ ...at, ...before }, false, r) });
        const w = Math.cos(x);
        const D = w * w - 2 * kappa * w - r;
        if (!(D > 0)) {
            break;
        }
        kappa = (kappa * w * w + 2 * r * w - r * kappa) / D;
        c = Math.sin(x) + kappa * (x + Math.PI);
        direction = -direction;
        run = Math.PI + x;
    }
    return collisions;
}

/// The contact (e, eta) of the chart bridge, with all that comes before and after it; of a body with the heights rho, too (L74).
export function bridgeOrbit(e, eta, q, rho = 1 / q) {
    const r = 1 / q;
    const R = q * rho * rho;
    const s = Math.cos(e);
    const etaBack = (eta * (1 + R * s * s)) / (1 + R * s * s + 2 * R * s * eta);
    const [out, back] = [rho * (s + eta), rho * (etaBack - s)];
    const height = rho * Math.sin(e);
    const middle = {
        t: 0,
        psi: Math.PI / 2 - e,
        y: height,
        heavy: true,
        before: { vpsi: -speed(back, r), vy: -back * speed(back, r) },
        after: { vpsi: -speed(out, r), vy: out * speed(out, r) },
    };
    const way = (slope, direction, run) => {
        const after = { vpsi: direction * speed(slope, r), vy: slope * speed(slope, r) };
        return rho === r ? follow(height + slope * run, slope, r, direction, run) : forward(q, { ...middle, ...after }, middle, middle, rho).collisions.slice(1);
    };
    return joined(q, middle, way(out, -1, Math.PI - e), way(back, +1, e), rho);
}

/// The extremal orbits of proofs/theorem.md, as limits of contacts with the bridge: at its top, and at its corner.
export const extremalOrbits = (q) => ({ top: bridgeOrbit(Math.PI / 2, 0, q), corner: bridgeOrbit(0, 0, q) });

/// The longest of the two orbits at q, the other one, and its name.
export function longestOrbit(q) {
    const { top, corner } = extremalOrbits(q);
    const isTop = top.collisions.length > corner.collisions.length;
    return { longest: isTop ? top : corner, other: isTop ? corner : top, name: isTop ? "over the top of the heavy mass\u2019s floor" : "out of the corner" };
}

/// The next ratio above (or below) q at which the longest orbit has another number of collisions, by bisection; null if there is none.
export function nextStep(q, by, { from, to }) {
    const count = (at) => longestOrbit(at).longest.collisions.length;
    const here = count(q);
    const end = by > 0 ? to : from;
    if (count(end) === here) {
        return null;
    }
    // Counts grow with q: the nearest other one is next to where this one ends.
    let [same, other] = [q, end];
    for (let i = 0; i < 60; ++i) {
        const middle = (same + other) / 2;
        [same, other] = count(middle) === here ? [middle, other] : [same, middle];
    }
    return other;
}
