"""Scene body, section tangents: format-sections.md, section 5; Theorem B and L79 to L83. Each bound is one orbit from below."""

from fractions import Fraction

from body import MOST_IN_CORNER, Bodies, corner_has
from fixed import Undecided, half_pi, interval, pi, point, sin_cos
from rays import at_most, earliest, reflected


class Valley:
    """Lower bounds of flights between R and the right half of the bridge, at Q."""

    def __init__(self, rho, q):
        self.rho, self.r = interval(rho), interval(1 / q).lower()
        self.walls = interval(1), self.rho

    def along_bridge(self):
        return interval(0), (-self.rho).lower()

    def tangent(self, e):
        sine, cosine = sin_cos(interval(e))
        c = (self.rho * (sine - interval(e) * cosine)).lower()
        return point(max(c.lo, 0)), (-(self.rho * cosine)).lower()

    def upward(self, e):
        """The tangent to the left, or the horizontal line over the top, which is as low as any."""
        place = interval(e)
        if not place < half_pi():
            return self.rho.lower(), interval(0)
        sine, cosine = sin_cos(place)
        return (self.rho * (sine + (pi() - place) * cosine)).lower(), (self.rho * cosine).lower()

    def bounce(self, wall, c, kappa):
        """Whether the wall may be hit, and the flight that comes back, or None if certainly none does."""
        height = self.walls[wall]
        scaled = (kappa / height).lower()
        x = None if scaled >= 1 else earliest((c / height).lower(), scaled, half_pi())
        if x is None:
            return False, None
        sine, cosine = sin_cos(x)
        top, d = reflected((height * cosine).upper(), kappa, self.r)
        if d.hi <= 0:
            return True, None
        top = top.lower()
        if d.lo <= 0 and top.lo < 0:
            raise Undecided("a flight that comes back")
        kappa = (top / (d.upper() if top.lo >= 0 else d.lower())).lower()
        return True, (point(max((height * sine + kappa * x).lower().lo, 0)), kappa)

    def hits_at_most(self, ray, most):
        """Does no flight above the ray hit the bridge more often?"""
        for hits in range(most + 1):
            ray = self.bounce(0, *ray)[1]
            if ray is None:
                return True
            hit, ray = self.bounce(1, *ray)
            if not hit or (ray is None and hits < most):
                return True
        return False

    def even_at_most(self, hits, most):
        """Is T <= most, if J is `hits`?"""
        ray = self.along_bridge()
        for number in range(2 * hits + 1):
            ray = self.bounce(number % 2, *ray)[1]
            if ray is None:
                return most >= 0
        kappa = ray[1]
        return most >= 0 and at_most((pi() * kappa).lower(), kappa, self.r, most)


class Tangents(Bodies):
    LEAVES = {"tangent": {"count": 2, "outside": 0}}

    def __init__(self, rho):
        super().__init__(rho)
        self.COVERS = {}
        # Of the least Q: greater ones have as many (L83).
        self.WITNESSES = {kind: lambda values, a, _b, holds=holds: holds(values, a, a) for kind, holds in self.WITNESSES.items()}

    def root(self, _chart, _b):
        return {"e": (Fraction(0), Fraction(2)), "rho": self.rho}

    def leaf(self, _chart, op, hints, box, upper):
        (e0, e1), q, (rho, greatest) = box["e"], box["q"][1], box["rho"]
        if op == "outside":
            return interval(e0) > half_pi()
        up, down = hints
        valley = Valley(rho, q)
        if rho != greatest or 2 * (up + down) >= upper or not (rho == 1 or at_most(*valley.upward(e1), valley.r, up)):
            return False
        return valley.hits_at_most(valley.tangent(e0), down) if e0 > 0 else self.at_corner(valley, down, upper, rho, q)

    @staticmethod
    def at_corner(valley, down, upper, rho, q):
        def has(count):
            return count > MOST_IN_CORNER or corner_has(count, rho, q)
        return ((valley.hits_at_most(valley.along_bridge(), down) or not has(2 * down + 3)) and
                (upper % 2 == 0 or valley.even_at_most(down, (upper - 1) // 2 - down - 1) or not has(2 * down + 2)))
