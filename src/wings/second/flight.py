"""The first reflection of a box of states, and bounds of the number of collisions after it: format-initial.md, 5 and 6."""

from fixed import Undecided, greatest, half_pi, hull, interval, meet, pi, sin_cos, span, square
from rays import earliest, greatest_count, latest, least_count, misses, off_bridge, reflected

GREATEST_STEPS, GREATEST_LATE_STEPS, GREATEST_BOUND = 1000, 64, 10 ** 6


def general_bound(r):
    """U: at least G of every ray with c >= 0 and kappa >= -r' at every r' >= r."""
    r_lo = r.lower()
    bound = greatest_count(pi() * r_lo, r_lo, r_lo, GREATEST_BOUND)
    if bound is None:
        raise Undecided("r is too small for a general bound")
    return 1 + bound


def greatest_number(r):
    """M: no trajectory has more collisions at any r' >= r."""
    r_lo = r.lower()
    if r_lo >= 1:
        return 2
    top = greatest_count(r_lo, interval(0).lower(), r_lo, GREATEST_BOUND)
    if top is None:
        raise Undecided("r is too small for a general bound")
    return min(1 + 2 * general_bound(r), 2 + 2 * top)


def sign(number, what):
    """1 or -1. What is divided by a number that may be negative is multiplied by it, as the divisor is."""
    if not (number > 0 or number < 0):
        raise Undecided(what)
    return 1 if number > 0 else -1


class Rays:
    """A box of rays: the wall that they leave ("bridge" or "light"), a and k."""

    def __init__(self, wall, a, k, r):
        self.wall, self.a, self.k, self.r = wall, a, k, r
        self.c = a if wall == "bridge" else a + pi() * k

    def passes_bridge(self):
        """Is it certain that no ray meets the bridge ahead?"""
        r_hi = self.r.upper()
        return (self.wall == "bridge" or self.k.lower() >= self.r
                or misses((self.a / r_hi).lower(), (self.k / r_hi).lower(), pi()))

    def count(self, lower, upper):
        """Bounds of F by rules 1 to 4, at most as good as asked for: lower <= F <= upper (None: no bound)."""
        k, r_lo = self.k, self.r.lower()
        if k >= 1:
            return 0, 0
        flat = k.lo >= -r_lo.lo
        if not flat:
            return 0, general_bound(r_lo) if self.wall == "bridge" else None
        high = greatest_count(greatest(self.c.lower(), 0), k, r_lo, upper)
        if self.passes_bridge():
            return least_count(greatest(self.c.upper(), 0), k, self.r, lower), high
        return 0, None if high is None else max(high, 1 + general_bound(r_lo))

    def step(self):
        """The rays after the next collision, if that is certain; None if it is certainly the last one."""
        return self._off_light_wall() if self.passes_bridge() else self._off_bridge()

    def _contact(self, c, k, end):
        """Encloses the contacts of all rays, if it is certain that all have one."""
        if not c > 0:
            raise Undecided("the next collision")
        low, high = earliest(c.lower(), k.lower(), end), latest(c.upper(), k.upper(), end)
        if low is None or high is None:
            raise Undecided("the next collision")
        return span(low, high)

    def _off_light_wall(self):
        k, r = self.k, self.r
        if not k < 1:
            raise Undecided("the next collision")
        x = self._contact(self.c, k, half_pi())
        sine, w = sin_cos(x)
        d = reflected(w, k, r)[1]
        if d <= 0:
            return None
        if not d > 0:
            raise Undecided("the direction behind a light wall")
        ends = [reflected(at_w, at_k, r) for at_w, at_k in ((w.upper(), k.lower()), (w.lower(), k.upper()))]
        slope = hull(*(numerator / at for numerator, at in ends))
        return Rays("light", sine + slope * x, slope, r)

    def _off_bridge(self):
        k, r = self.k, self.r
        if not k / r < 1:
            raise Undecided("the next collision")
        x = self._contact(self.a / r, k / r, pi())
        sine, w = sin_cos(x)
        onward = sign(off_bridge(w, k, r)[0], "the direction behind the bridge")
        ends = [off_bridge(at_w, at_k, r) for at_w, at_k in ((w.lower(), k.upper()), (w.upper(), k.lower()))]
        slope = hull(*(p / (e * onward) for e, p in ends))
        return Rays("bridge", r * sine + slope * (pi() - x if onward > 0 else x), slope, r)


def counts_within(rays, low, high):
    """Is low <= F <= high certified? (None: no bound.)"""
    late = 0
    for n in range(GREATEST_STEPS):
        if low is not None and n >= low:
            low = None
        if high is not None and n > high:
            return False
        least, most = rays.count(0 if low is None else low - n, 0 if high is None else high - n)
        if low is not None and n + least >= low:
            low = None
        if high is not None and most is not None and n + most <= high:
            high = None
        if low is None and high is None:
            return True
        late += rays.k.lo >= -rays.r.lo
        if late > GREATEST_LATE_STEPS:
            return False
        rays = rays.step()
        if rays is None:
            return (low is None or n + 1 >= low) and (high is None or n + 1 <= high)
    return False


def first_angle(air, mass, times):
    """Encloses phi' in the mean value form and as phi + w T; the clearances fall at all times of T, else Undecided."""
    at, moment = air.middle(), times.middle()
    t = meet(times, moment + at.clearance(mass, moment) / -at.clearance_rate(mass, times))
    plain = air.phi + air.w * times
    change = (air.v * ((air.phi - at.phi) + times * (air.w - at.w))
              - air.w * ((air.h - at.h) + times * (air.v - at.v)))
    if mass == "heavy":
        change = change + air.w * sin_cos(plain)[0] * (air.r - at.r)
    return meet(plain, at.phi + at.w * t - change / -air.clearance_rate(mass, times))


def first_reflection(air, mass, times):
    """The rays after a first contact in the given times, or None if no collision follows."""
    angle, r = first_angle(air, mass, times), air.r
    c = sin_cos(angle)[1]
    falls = air.v < 0
    if falls:
        steepness, turn = air.w / -air.v, 1
    else:
        turn = sign(air.w, "neither falling nor turning")
        steepness = air.v * turn / (air.w * turn)

    def direction(m, c):
        """D and P."""
        turning, rising = (m, -1) if falls else (1, m)
        base, side = (r - square(c), 1) if mass == "light" else (1 - r * square(c), -1)
        return turning * base - 2 * side * rising * c, -rising * base - 2 * side * r * turning * c

    d, p = direction(steepness, c)
    d, p = turn * d, turn * p
    if p > 0 and p >= d and p >= -d:
        return None
    onward = sign(d, "the direction behind the first contact")
    ends = ((steepness.lower(), c.lower()), (steepness.upper(), c.upper())) if mass == "light" else (
        (steepness.lower(), c.upper()), (steepness.upper(), c.lower()))
    slopes = [direction(*end) for end in ends]
    slope = hull(*(at_p * turn / (at_d * turn * onward) for at_d, at_p in slopes))

    # phi' lies on one hump, [n pi, (n + 1) pi]; light humps have odd n.
    n = angle.lo // pi().lo
    if not (angle > pi() * n and angle < pi() * (n + 1)):
        raise Undecided("the hump of the first contact")
    if mass == "light":
        peak = pi() * n + half_pi()
        if not (angle > peak or angle < peak):
            raise Undecided("the side of the peak")
        if (angle > peak) != (onward > 0):
            return None
    sine = sin_cos(angle)[0]
    away = pi() * (n + 1) - angle if onward > 0 else angle - pi() * n
    height = -sine if mass == "light" else r * sine
    return Rays("light" if mass == "light" else "bridge", height + slope * away, slope, r)
