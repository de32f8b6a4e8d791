"""A box of states in the air and its first contact: format-initial.md, sections 3 and 4."""

from fractions import Fraction

from fixed import greatest, hull, interval, precision, sin_cos

GREATEST_SPANS = 1024


class Air:
    """The intervals phi, w, h, v and r of a leaf; independent from here on."""

    def __init__(self, box):
        phi, self.w, y, ydot, self.r = (hull(*ends) for ends in (
            box["phi"], box["phidot"], box["y"], box["ydot"], (1 / box["q"][1], 1 / box["q"][0])))
        self.phi, self.h, self.v = phi, y * (1 + self.r), ydot * (1 + self.r)

    def middle(self):
        """The same as a single state of the box."""
        state = object.__new__(Air)
        for name, value in vars(self).items():
            setattr(state, name, value.middle())
        return state

    def clearance(self, mass, t):
        sine = sin_cos(self.phi + self.w * t)[0]
        return self.h + self.v * t + (sine if mass == "light" else -self.r * sine)

    def clearance_rate(self, mass, t):
        slope = self.w * sin_cos(self.phi + self.w * t)[1]
        return self.v + (slope if mass == "light" else -self.r * slope)

    def closed(self, end, mass=None):
        """Is [0, end] closed for the mass (None: for none)? `end` is an exact fraction."""
        spans, looked = [(Fraction(0), Fraction(end))], 0
        while spans:
            looked += 1
            if looked > GREATEST_SPANS:
                return False
            low, high = spans.pop()
            if not self._span_closed(low, high, mass):
                middle = (low + high) / 2
                spans += [(middle, high), (low, middle)]
        return True

    def _span_closed(self, low, high, mass):
        times = hull(low, high)
        if self.h + self.v * times > 1:
            return True
        for other in ("light", "heavy"):
            rate = self.clearance_rate(other, times)
            if other == mass and rate < 0:
                continue
            if not self.clearance(other, interval(low)) + interval(high - low) * least_zero(rate) > 0:
                return False
        return True


def least_zero(rate):
    """min(0, lower end)."""
    return -greatest(-rate.lower(), 0)


def is_first_contact(air, mass, t0, t1):
    """Is the first collision of every state one of the mass, transversal, at a time in [t0, t1]?"""
    return (air.clearance(mass, interval(t0)) > 0 and air.clearance(mass, interval(t1)) < 0
            and air.clearance_rate(mass, hull(t0, t1)) < 0 and air.closed(t1, mass))


def has_no_collision(air):
    if air.v > 0 and air.v >= air.w and air.v >= -air.w:
        return True
    if air.v >= 0 and air.h > 1:
        return True
    if not air.v > 0:
        return False
    end = greatest((1 - air.h) / air.v, 0)
    return air.closed(Fraction(end.hi, 1 << precision()))
