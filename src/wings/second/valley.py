"""The valley of bodies, between R and the right half of the bridge, from below: format-sections.md, section 5; L79, L82."""

from fixed import Undecided, half_pi, interval, pi, point, sin_cos
from rays import at_most, earliest, reflected


def contact_from_below(height, c, kappa):
    """A place before the contacts of all flights above (c, kappa) with a wall; None if they miss it."""
    kappa = (kappa / height).lower()
    return None if kappa >= 1 else earliest((c / height).lower(), kappa, half_pi())


class Valley:
    """Lower bounds of flights between R and the right half of the bridge, at Q."""

    def __init__(self, rho, q):
        self.rho, self.r = interval(rho), interval(1 / q).lower()
        self.walls = interval(1), self.rho

    def bounce(self, wall, c, kappa):
        """Whether the wall may be hit, and the flight that comes back, or None if certainly none does."""
        height = self.walls[wall]
        x = contact_from_below(height, c, kappa)
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

    def along_bridge(self, hits):
        """The straight wedge's ray along the bridge, behind 2 hits + 1 bounces, or None if it ends before."""
        ray = interval(0), (-self.rho).lower()
        for number in range(2 * hits + 1):
            ray = self.bounce(number % 2, *ray)[1]
            if ray is None:
                return None
        return ray

    def corner_hits_at_most(self, most):
        """Is J <= most?"""
        ray = self.along_bridge(most)
        return ray is None or ray[1] >= self.rho

    def even_at_most(self, hits, most):
        """Is T <= most, if J is `hits`?"""
        ray = self.along_bridge(hits)
        if ray is None or most < 0:
            return most >= 0
        kappa = ray[1]
        return at_most((pi() * kappa).lower(), kappa, self.r, most)
