// The time of a picture against the time of an orbit. A position p counts flights: floor(p) is the flight, its fraction how much
// of it has been shown, slower near collisions.

const flightSeconds = 1.95; // to show a flight of middling length
const nearSpeed = 0.25; // at a collision, of the flight's own speed

export class Clock {
    constructor(orbit) {
        const { collisions, first, last } = orbit;
        this.times = [first.until, ...collisions.map((c) => c.t), last.until];
        const lengths = this.times.slice(1).map((t, i) => t - this.times[i]);
        const middle = [...lengths].sort((a, b) => a - b)[lengths.length >> 1] || 1;
        this.seconds = lengths.map((length) => flightSeconds * Math.min(2.5, Math.max(0.35, length / middle)));
        this.flights = lengths.length;
    }

    /// The orbit's time at position p.
    time(p) {
        const i = Math.min(this.flights - 1, Math.max(0, Math.floor(p)));
        const s = Math.min(1, Math.max(0, p - i));
        const m0 = i > 0 ? nearSpeed : 1;
        const m1 = i < this.flights - 1 ? nearSpeed : 1;
        const share = ((m0 + m1 - 2) * s + (3 - 2 * m0 - m1)) * s * s + m0 * s;
        return this.times[i] + (this.times[i + 1] - this.times[i]) * share;
    }

    /// The position `seconds` later.
    later(p, seconds) {
        while (seconds > 0 && p < this.flights) {
            const i = Math.floor(p);
            const whole = this.seconds[i];
            const left = (i + 1 - p) * whole;
            if (seconds < left) {
                return p + seconds / whole;
            }
            seconds -= left;
            p = i + 1;
        }
        return Math.min(p, this.flights);
    }
}
