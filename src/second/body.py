"""Scene body: format-sections.md, section 4; lemmas L71 to L75. States are carried as intervals."""

from collections import namedtuple

from failure import Limit
from fixed import greatest, half_pi, interval, least, meet, pi, sin_cos, span, square
from full import below_time, root, steep_time
from plain import new_slope, returning, wall
from rays import earliest, latest
from work import spend

MOST_FLIGHTS, MOST_IN_CORNER = 100_000, 10_000

# States in the air: a ray of height c over the corner before it, or, if c is None, a departure from (x, sin x) on a light wall.
Flight = namedtuple("Flight", "kappa c x sine", defaults=(None, None, None))


def over_corner(flight):
    """The height of a departure over the far corner."""
    return flight.sine + flight.kappa * (flight.x + pi())


class Body:
    """The intervals r, rho and g of a box."""

    def __init__(self, q, rho):
        self.r = span(interval(1 / q[1]), interval(1 / q[0]))
        self.rho = span(interval(rho[0]), interval(rho[1]))
        self.g = span(interval(1 / (q[1] * rho[1])), interval(1 / (q[0] * rho[0])))
        self.massless = q[0] * rho[0] == q[1] * rho[1] == 1  # of no range, as both grow

    def contacts(self, flight):
        """Encloses the first contacts with the bridge of departures, and says whether all have one; None if none has."""
        rho_lo, rho_hi = self.rho.lower(), self.rho.upper()
        h, kappa = greatest(flight.sine + flight.kappa * flight.x, 0), flight.kappa
        first = None if kappa >= rho_hi else earliest((h / rho_hi).lower(), (kappa / rho_hi).lower(), pi())
        if first is None:
            return None
        last, below = steep_time(kappa.lower(), rho_lo, rho_hi), below_time(h.upper(), kappa.upper(), rho_lo)
        last = last if below is None else least(last, below)
        return span(first, greatest(last, first)), below is not None

    def behind_bridge(self, t, kappa):
        """E and P at the contacts t."""
        s = sin_cos(t)[1]
        fall = self.rho * square(s)
        turn = 2 * self.r * s
        return self.g + 2 * s * kappa - fall, meet(turn - kappa * (self.g - fall), turn - kappa * self.g + kappa * fall)

    def ray(self, t, slope, side):
        """From the contacts t: to the left (side = 1), or to the right (-1)."""
        return Flight(slope, self.rho * sin_cos(t)[0] + slope * (pi() - t if side > 0 else t))

    def rays(self, t, kappa):
        """All that may come back from the contacts t of flights of slope kappa; None if that is not known."""
        e, p = self.behind_bridge(t, kappa)
        found = []
        for side in (1, -1):
            speed = side * e
            if speed <= 0:
                continue
            if not speed > 0 and not p > 0:
                return None
            slope = p / speed if speed > 0 else span(p.lower() / speed.upper(), greatest(p.lower() / speed.upper(), 1))
            if not slope >= 1:
                found.append(self.ray(t, slope, side))
        return found

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
                    rays = self.rays(met[0], kappa) if limit > 0 else None
                    if rays is None:
                        return False
                    todo += [(ray, limit - 1, self.massless) for ray in rays]
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
                e, p = self.behind_bridge(met[0], kappa)
                if not (e > 0 or e < 0):
                    return False
                flight = self.ray(met[0], p / e if e > 0 else p / -e, 1 if e > 0 else -1)
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


class Bodies:
    """The section, for all bodies with rho in [R0, R1]."""

    CHARTS = {"contact": ("t", "eta", "q", "rho"), "departure": ("e", "eta", "q", "rho")}
    LEAVES = {"contact": {"count": 1, "outside": 0}, "departure": {"count": 1, "outside": 0}}
    def __init__(self, rho):
        self.rho = rho
        self.COVERS = {"symmetric": self.symmetric}
        self.WITNESSES = {"bridge": self.from_bridge, "corner": self.in_corner}

    def root(self, chart, b):
        return {**root(chart, b), "rho": self.rho}

    def symmetric(self, a, b, upper):
        return self.rho == (1, 1) and not corner_has(upper + 1, self.rho[1], b)

    def leaf(self, chart, op, hints, box):
        eta0, eta1 = box["eta"]
        eta = span(interval(eta0), interval(eta1))
        if chart == "contact":
            t0, t1 = box["t"]
            if op == "outside":
                return interval(t0) > pi() or box["rho"][0] * (eta0 - 1) >= 1
            t = span(least(t0, pi()), least(t1, pi()))
            sine, cosine = sin_cos(t)
            body = Body(box["q"], box["rho"])
            ray = Flight(body.rho * (cosine + eta), body.rho * (sine + (cosine + eta) * (pi() - t)))
            return body.at_most(ray, hints[0], body.massless)
        e0, e1 = box["e"]
        if op == "outside":
            return interval(e0) > half_pi() or eta0 - sin_cos(interval(e0))[1] >= 1
        e = span(least(e0, half_pi()), least(e1, half_pi()))
        sine, cosine = sin_cos(e)
        return Body(box["q"], box["rho"]).at_most(Flight(eta - cosine, None, e, sine), hints[0], False)

    def from_bridge(self, values, q_lo, q_hi):
        exact_e, exact_eta, a, b = values
        e, eta, body = interval(exact_e), interval(exact_eta), Body((q_lo, q_hi), self.rho)
        if not (exact_e > 0 and e < half_pi() and exact_eta > 0):
            return False
        sine, s = sin_cos(e)
        big_r = square(body.rho) / body.r
        base = 1 + big_r * square(s)
        forward, backward = s + eta, eta * base / (base + 2 * big_r * s * eta) - s
        return (body.at_least(Flight(body.rho * forward, body.rho * (sine + forward * (pi() - e))), a)
                and body.at_least(Flight(body.rho * backward, body.rho * (sine + backward * e)), b))

    def in_corner(self, values, q_lo, _q_hi):
        return values[0] == values[1] == values[3] == 0 and corner_has(1 + values[2], self.rho[0], q_lo)
