"""Scene body: format-sections.md, section 4; lemmas L71 to L75. States are carried as intervals, in the section plain, too (L16)."""

from collections import namedtuple

from failure import Limit
import full
from fixed import Undecided, greatest, half_pi, hull, interval, least, meet, pi, sin_cos, span, square
from full import steep_time
from rays import earliest, latest, off_bridge, reflected
from work import spend

MOST_FLIGHTS, MOST_IN_CORNER = 100_000, 10_000

# States in the air: a ray of height c over the corner before it, or, if c is None, a departure from (x, sin x) on a light wall.
Flight = namedtuple("Flight", "kappa c x sine", defaults=(None, None, None))


def over_corner(flight):
    """The height of a departure over the far corner."""
    return flight.sine + flight.kappa * (flight.x + pi())


def returning(slope):
    """Slopes that may come back: at most 1 (L3); None if there are none."""
    return None if slope is None or slope >= 1 else least(slope, 1)


def quotient(top, bottom):
    """Encloses those slopes top / bottom whose bottom is positive, but none above 1 if others may not be; None if there are none."""
    if bottom <= 0:
        return None
    if bottom > 0:
        return top / bottom
    if not top > 0:
        raise Undecided("a direction")
    flattest = top.lower() / bottom.upper()
    return span(flattest, greatest(flattest, 1))


def new_slope(w, kappa, r):
    """Encloses the slopes after a light wall that may come back; None if it is certain that none does."""
    top, d = reflected(w, kappa, r)
    d = meet(d, w * (w - 2 * kappa) - r)
    slope = quotient(meet(top, kappa * (square(w) - r) + 2 * r * w), d)
    if w > 0 and d > 0:
        a = (w - r / w) / 2
        if a > kappa:
            slope = meet(slope, (square(a) + r) / (a - kappa) - a)
            slope = meet(slope, kappa + (r + square(kappa)) / (a - kappa))
    return returning(slope)


def wall(c, kappa, r):
    """One flight to a light wall: None if all rays certainly miss, else what encloses x, sin x and the new slopes (or None) of
    those that do not."""
    c = greatest(c, 0)
    x_low = earliest(c.lower(), kappa.lower())
    if x_low is None:
        return None
    x_high = latest(c.upper(), kappa.upper())
    x = span(x_low, half_pi() if x_high is None else x_high)
    sine, w = sin_cos(x)
    w = greatest(w, greatest(kappa.lower(), 0)) if x_high is None else w
    return x, sine, new_slope(w, kappa, r)


class Body:
    """The intervals r, rho and g of a box; without rho it is about the dumbbell, and rho = r."""

    def __init__(self, q, rho):
        self.r = hull(1 / q[1], 1 / q[0])
        self.rho, self.g, self.massless = self.r, interval(1), True
        if rho:
            self.rho, self.g = hull(*rho), hull(1 / (q[1] * rho[1]), 1 / (q[0] * rho[0]))
            self.massless = q[0] * rho[0] == q[1] * rho[1] == 1  # of no range, as both grow

    def contacts(self, flight):
        """Encloses the first contacts with the bridge of departures, and says whether all have one; None if none has."""
        rho_lo, rho_hi = self.rho.lower(), self.rho.upper()
        h, kappa = greatest(flight.sine + flight.kappa * flight.x, 0), flight.kappa
        first = None if kappa >= rho_hi else earliest((h / rho_hi).lower(), (kappa / rho_hi).lower(), pi())
        if first is None:
            return None
        last = steep_time(kappa.lower(), rho_lo, rho_hi)
        below = latest((h / rho_lo).upper(), (kappa / rho_lo).upper(), pi())
        last = last if below is None else least(last, below)
        return span(first, greatest(last, first)), below is not None

    def ray(self, sine, steepness, away):
        """From a contact with the bridge, whose end is so far away."""
        return Flight(self.rho * steepness, self.rho * (sine + steepness * away))

    def rays(self, t, kappa):
        """All that may come back from the contacts t of flights of slope kappa, to the left or to the right."""
        sine, s = sin_cos(t)
        e, p = off_bridge(s, kappa, self.r, self.rho, self.g)
        slopes = (quotient(p, e), pi() - t), (quotient(p, -e), t)
        return [Flight(slope, self.rho * sine + slope * away) for slope, away in slopes if slope is not None]

    def at_most(self, flight, limit, clear):
        """At most `limit` later collisions? `clear`: the bridge is out of reach."""
        todo = [(flight, limit, clear)]
        while todo:
            if len(todo) > MOST_FLIGHTS:
                raise Limit(f"more than {MOST_FLIGHTS} flights at once")
            flight, limit, clear = todo.pop()
            while True:
                kappa = returning(flight.kappa)
                if kappa is None:
                    break
                flight = flight._replace(kappa=kappa)
                met = None if clear or flight.c is not None else self.contacts(flight)
                if met:
                    if limit == 0:
                        return False
                    todo += [(ray, limit - 1, self.massless) for ray in self.rays(met[0], kappa)]
                    if met[1]:
                        break
                hit = wall(over_corner(flight) if flight.c is None else flight.c, kappa, self.r)
                if hit is None:
                    break
                if limit == 0:
                    return False
                limit -= 1
                if hit[2] is None:
                    break
                flight = Flight(hit[2], None, *hit[:2])
        return True

    def at_least(self, flight, count):
        """At least `count` later collisions?"""
        while count > 0:
            kappa = flight.kappa
            met = self.contacts(flight) if flight.c is None else None
            if met:
                if count == 1 or not met[1]:
                    return met[1]
                count -= 1
                rays = self.rays(met[0], kappa)
                if len(rays) != 1 or not rays[0].kappa < 1:  # at 1 it may have been cut
                    return False
                flight, = rays
                continue
            c = over_corner(flight) if flight.c is None else flight.c
            if flight.c is None and not c > 0:
                return False
            c = greatest(c, 0)
            last = latest(c.upper(), kappa.upper()) if kappa < 1 else None
            if last is None or count == 1:
                return last is not None
            count -= 1
            x = span(earliest(c.lower(), kappa.lower()), last)
            sine, w = sin_cos(x)
            if not w * w - 2 * kappa * w - self.r > 0:
                return False
            slope = new_slope(w, kappa, self.r)
            if slope is None or not slope < 1:  # at 1 it may have been cut
                return False
            flight = Flight(slope, None, x, sine)
        return True


def corner_has(count, rho, q):
    """Is ceil(pi/corner) >= count? In whole numbers: a_j and b_j of L73, times the power j of the denominators."""
    (over, under), (n, m) = rho.as_integer_ratio(), q.as_integer_ratio()
    p, step, back = n * over - m * under, m * (over + under), n * (over + under)
    a, b = p, step
    for j in range(1, count):
        if b <= 0:
            return False
        if j > MOST_IN_CORNER:
            raise Limit(f"more than {MOST_IN_CORNER} collisions in the corner")
        spend(1000 + a.bit_length() * back.bit_length() // 100)
        a, b = p * a - back * b, step * a + p * b
    return True


def states_at_most(chart, box, limit):
    """At most `limit` later collisions of all states of the box?"""
    body, eta, end = Body(box["q"], box.get("rho")), hull(*box["eta"]), pi() if chart == "contact" else half_pi()
    place = hull(*(least(number, end) for number in box["t" if chart == "contact" else "e"]))
    sine, cosine = sin_cos(place)
    if chart == "contact":
        return body.at_most(body.ray(sine, cosine + eta, pi() - place), limit, body.massless)
    return body.at_most(Flight(eta - cosine, None, place, sine), limit, False)


def leaf(chart, op, hints, box, upper):
    return full.leaf(chart, op, hints, box, upper, states_at_most)


class Bodies:
    """The section, for all bodies with rho in [R0, R1]."""

    leaf = staticmethod(leaf)

    LEAVES = {chart: full.LEAVES[chart] for chart in ("contact", "departure")}

    def __init__(self, rho):
        self.rho = rho
        self.COVERS = {"symmetric": self.symmetric}
        self.WITNESSES = {"bridge": self.from_bridge, "corner": self.in_corner}

    def root(self, chart, b):
        return {**full.root(chart, b), "rho": self.rho}

    def symmetric(self, a, b, upper):
        return self.rho == (1, 1) and not corner_has(upper + 1, self.rho[1], b)

    def from_bridge(self, values, q_lo, q_hi):
        exact_e, exact_eta, a, b = values
        e, eta, body = interval(exact_e), interval(exact_eta), Body((q_lo, q_hi), self.rho)
        if not (exact_e > 0 and e < half_pi() and exact_eta > 0):
            return False
        sine, s = sin_cos(e)
        big_r = square(body.rho) / body.r
        base = 1 + big_r * square(s)
        before = eta * base / (base + 2 * big_r * s * eta)
        return body.at_least(body.ray(sine, s + eta, pi() - e), a) and body.at_least(body.ray(sine, before - s, e), b)

    def in_corner(self, values, q_lo, _q_hi):
        return values[0] == values[1] == values[3] == 0 and corner_has(1 + values[2], self.rho[0], q_lo)
