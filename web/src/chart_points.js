// Where the collisions of an orbit lie in the charts of a full section: mirrored so that they leave to the left.

/// [position, slope] of each collision in the chart `contact` (heavy) or `departure` (light), in order.
export function chartPoints(orbit, chart) {
    const { rho } = orbit;
    const points = [];
    for (const { psi, heavy, after } of orbit.collisions) {
        const side = after.vpsi < 0 ? 1 : -1; // mirrored if it leaves to the right
        const slope = after.vy / Math.abs(after.vpsi);
        if (chart === "contact" && heavy) {
            const t = Math.PI / 2 - side * psi;
            points.push([t, slope / rho - Math.cos(t)]);
        }
        if (chart === "departure" && !heavy && side * psi > 0) {
            const e = side * psi - Math.PI / 2;
            points.push([e, slope + Math.cos(e)]);
        }
    }
    return points;
}
