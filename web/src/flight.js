// The dumbbell as a point (psi, y) above its floor (lemma L0): y in units of beta2, psi = phi - pi/2, r = 1/q. A body with mass
// between its contacts (L70) has a floor of its own, rho for r. Doubles: an illustration, no proof.

const mostPieces = 100000; // monotone pieces of one flight

/// The floor under the light mass is -cos psi, under the heavy one rho cos psi.
export const floorAt = (psi, rho) => Math.max(-Math.cos(psi), rho * Math.cos(psi));

const slopeAt = (psi, heavy, rho) => (heavy ? -rho : 1) * Math.sin(psi);

/// The velocity behind a collision: equation (1) of L0.
export function reflected({ psi, vpsi, vy }, heavy, r, rho = r) {
    const slope = slopeAt(psi, heavy, rho);
    const k = (2 * (vy - slope * vpsi)) / (slope * slope + r);
    return { vpsi: vpsi + k * slope, vy: vy - k * r };
}

/// The sine of the angle between flight and floor, in the metric of the kinetic energy.
export function grazingSine(state, heavy, r, rho = r) {
    const slope = slopeAt(state.psi, heavy, rho);
    const speed = Math.sqrt(state.vpsi ** 2 + state.vy ** 2 / r);
    return Math.abs(state.vy - slope * state.vpsi) / Math.sqrt(slope * slope + r) / speed;
}

/// Behind this time a flight is above every floor, or (descending) below it.
function horizon({ y, vpsi, vy }) {
    if (vy > 0) {
        return y > 1 ? 0 : (1 - y) / vy;
    }
    if (vy < 0) {
        return (y + 1.5) / -vy;
    }
    return y >= 1 || vpsi === 0 ? 0 : (2 * Math.PI) / Math.abs(vpsi);
}

/// When the clearance y + vy t + A cos(psi + vpsi t) of a mass first falls through 0, in (0, until); null if it does not. It is
/// monotone between the times at which sin(psi + vpsi t) = vy / (A vpsi).
function firstFall({ psi, y, vpsi, vy }, A, until) {
    const clearance = (t) => y + vy * t + A * Math.cos(psi + vpsi * t);
    const s = vy / (A * vpsi);
    const turns = Math.abs(s) < 1 ? [Math.asin(s), Math.PI - Math.asin(s)] : [];
    const circle = 2 * Math.PI;
    /// The time from the start to the k-th passage of an angle.
    const time = (angle, k) => {
        const way = ((vpsi > 0 ? angle - psi : psi - angle) % circle + circle) % circle;
        return (way + circle * k) / Math.abs(vpsi);
    };
    const order = turns.map((angle) => time(angle, 0)).sort((a, b) => a - b);
    let from = vy < 0 ? Math.max(0, (y - Math.abs(A)) / -vy) : 0; // before that it is too high
    const skipped = Math.floor((from * Math.abs(vpsi)) / circle); // turns
    for (let i = 0; i < mostPieces; ++i) {
        const turn = order.length > 0 ? order[i % order.length] + (circle * (skipped + Math.floor(i / order.length))) / Math.abs(vpsi) : Infinity;
        const to = Math.min(until, turn);
        if (to > from && clearance(to) < 0 && clearance((from + to) / 2) < clearance(from) + 1e-300) {
            return fall(clearance, from, to);
        }
        if (!(turn < until)) {
            return null;
        }
        from = Math.max(from, to);
    }
    return null;
}

/// Bisection: clearance(from) >= 0 > clearance(to).
function fall(clearance, from, to) {
    for (let middle = (from + to) / 2; middle > from && middle < to; middle = (from + to) / 2) {
        [from, to] = clearance(middle) < 0 ? [from, middle] : [middle, to];
    }
    return to;
}

/// The next contact {after, heavy} of a flight, or null. `left`: the mass that it has just left the floor with.
export function nextContact(state, rho, left = null) {
    const until = horizon(state);
    let next = null;
    for (const heavy of [false, true]) {
        const after = firstFall(state, heavy ? -rho : 1, next?.after ?? until);
        if (after !== null && !(left === heavy && after < 1e-12 * (1 + until))) {
            next = { after, heavy };
        }
    }
    return next;
}
