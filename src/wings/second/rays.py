"""Bounds of G, the number of collisions of a ray with the light walls: format.md 3.2, lemmas L4, L5 and L12."""

import itertools
import math

from fixed import Undecided, half_pi, interval, meet, pi, point, precision, sin_cos, square


def _guess(c, kappa, end):
    """About the least root x of sin x = c + kappa x, or None if doubles find none in [0, end], or see no steep one."""
    c, kappa, end, x = float(c), float(kappa), float(end), 0.0
    for _ in range(80):
        above, steepness = math.sin(x) - kappa * x - c, math.cos(x) - kappa
        if steepness <= 1e-6 or x > end + 0.03:
            return None
        step = -above / steepness
        x += step
        if step <= 1e-17 + 1e-15 * x:
            break
    return interval(min(max(x, 0.0), end - 1e-5)).lower()


def crest(kappa, end):
    """A point of [0, end], about where sin x - kappa x is greatest: a guess, on either side of that."""
    z = interval(min(math.acos(min(max(float(kappa), -1.0), 1.0)), float(end) - 1e-5)).middle()
    try:
        for _ in range(1 + precision() // 100):  # Newton's steps double the digits
            sine, cosine = sin_cos(z)
            z = (z + (cosine - kappa) / sine).middle()
    except Undecided:
        pass
    return point(min(max(z.lo, 0), end.lo))


def _near(c, kappa, end):
    """A point near the contact if there is one."""
    z = _guess(c, kappa, end)
    if z is not None:
        return z
    z = crest(kappa, end)  # about the contact, the wall's height above the ray is a parabola with its top there
    sine = sin_cos(z)[0]
    height = sine - kappa * z - c
    try:
        return point(max(z.lo - math.isqrt(max((2 * height / sine).lo, 0) << precision()), 0))
    except Undecided:
        return z


def _tangent(z, end):
    """Sine and cosine at z. The tangent there is above the sine on all of [0, end], where it is concave; else Undecided."""
    if not (0 <= z.lo and z.hi <= end.lo and end.hi <= pi().hi):
        raise Undecided("no tangent of this wall")
    return sin_cos(z)


def misses(c, kappa, end):
    """Is it certain that no x in [0, end] has sin x >= c + kappa x? (L12 (c), on [0, pi] as well: there sine is concave)"""
    z = crest(kappa, end)
    sine, cosine = _tangent(z, end)
    return c - sine + z * cosine > 0 and c + kappa * end - sine - (end - z) * cosine > 0


def _tangent_step(c, kappa, z, end):
    """A point below which no x of [0, end] has sin x >= c + kappa x, by the tangent at z (L12 (a)); the steepness there. If
    that may be 0 or negative, as behind the crest, it would be no bound: Undecided."""
    sine, cosine = _tangent(z, end)
    steepness = cosine - kappa
    return (z - (sine - kappa * z - c) / steepness).lower(), steepness


def _refined(c, kappa, z, end):
    """Tangent steps from z: a point below which no x of [0, end] has sin x >= c + kappa x, the last step and its steepness."""
    for _ in range(2 + precision() // 50):
        new, steepness = _tangent_step(c, kappa, z, end)
        step, z = abs(new.lo - z.lo), point(max(new.lo, 0))
        if step >> precision() // 2 == 0 or not z <= end:
            break
    return z, point(step), steepness


def earliest(c, kappa, end=None):
    """A lower bound x of the contact in [0, end] (pi/2, if None) of every ray at or above (c, kappa). None if these miss
    certainly: that is proved by `misses`, or by a bound behind the end."""
    end = half_pi() if end is None else end
    z = _guess(c, kappa, end)
    if z is None:
        if misses(c, kappa, end):
            return None
        z = _near(c, kappa, end)
    for start in (z, point(z.lo - (1 << precision()) // 10 ** 6)):  # the second one, if z is behind the crest
        try:
            bound = _refined(c, kappa, point(max(start.lo, 0)), end)[0]
            return None if bound > end else bound
        except Undecided:
            pass
    return interval(0)


def latest(c, kappa, end=None):
    """A point x of [0, end] (pi/2, if None) with certified sin x > c + kappa x, near the contact of (c, kappa); or None, which
    says nothing. As c >= 0 (else Undecided), all rays at or below (c, kappa) with c >= 0 have a contact in [0, x]."""
    if not c >= 0:
        raise Undecided("a ray from below the corner")
    end = half_pi() if end is None else end
    tries = []
    try:
        z, step, steepness = _refined(c, kappa, _near(c, kappa, end), end)
        # z is too small by about step^2 / steepness.
        away = (step * step + point(64 * precision())) / steepness
        tries = [point(z.lo + (away.hi << 4 * i)) for i in range(4)]
    except Undecided:
        pass
    for x in [*tries, crest(kappa, end)]:
        if 0 <= x.lo <= end.lo and sin_cos(x)[0] > c + kappa * x:
            return x
    return None


def reflected(w, kappa, r):
    """Encloses the numerator and the denominator D of the new slope (2)."""
    ww = w * w
    return kappa * ww + (w * 2 - kappa) * r, ww - kappa * w * 2 - r


def off_bridge(s, kappa, r, rho=None, g=1):
    """Encloses E and P: behind a contact with the bridge, of the cosine s, the slope is P/E to the left, -P/E to the right (L71).
    For the dumbbell rho = r and g = 1."""
    fall, turn = (r if rho is None else rho) * square(s), 2 * r * s
    return g + 2 * s * kappa - fall, meet(turn - kappa * (g - fall), turn - kappa * g + kappa * fall)


def slope_above(w, kappa, r):
    """An upper bound of the new slope where the cosine is at least the lower end of w, kappa and r at most their upper ends,
    L5 (b), and then they go back; None if w > 0 and D > 0 are not certain, without which it would be no bound."""
    w = w.lower()
    numerator, d = reflected(w, kappa.upper(), r.upper())
    return (numerator / d).upper() if w > 0 and d > 0 else None


def greatest_count(c, kappa, r, limit):
    """An upper bound of G for the rays whose c, kappa and r are at least the lower ends of these, L5 (e); None if it would be
    above the limit. Undecided if these ends do not have c >= 0, kappa >= -r and r > 0, as L5 wants of the rays."""
    c, kappa, r = c.lower(), kappa.lower(), r.lower()
    if not (c >= 0 and kappa >= -r and r > 0):
        raise Undecided("where L5 does not hold")
    for count in itertools.count():
        if kappa >= 1:
            return count
        x = earliest(c, kappa)
        if x is None:
            return count
        if count == limit:
            return None
        sine, cosine = sin_cos(x)
        numerator, d = reflected(cosine.upper(), kappa, r)
        if d.hi <= 0:
            return count + 1
        kappa = point(max((numerator.lower() / d.upper()).lo, 0))
        c = point(max((sine + kappa * (x + pi())).lo, 0))


def at_most(c, kappa, r, limit):
    """Is G <= limit certified for them?"""
    found = greatest_count(c, kappa, r, limit)
    return found is not None and found <= limit


def least_count(c, kappa, r, limit):
    """A lower bound of G for the rays with c >= 0 and kappa >= -r whose c, kappa and r are at most the upper ends of these,
    L5 (e); not above the limit. Undecided if there are none."""
    c, kappa, r = c.upper(), kappa.upper(), r.upper()
    if not (c >= 0 and kappa >= -r):
        raise Undecided("where L5 does not hold")
    for count in range(limit):
        x = latest(c, kappa) if kappa < 1 else None
        if x is None:
            return count
        sine, cosine = sin_cos(x)
        kappa = slope_above(cosine, kappa, r)
        if kappa is None:
            return count + 1
        c = (sine + kappa * (x + pi())).upper()
    return limit


def at_least(c, kappa, r, count):
    """Is G >= count certified for them?"""
    return least_count(c, kappa, r, count) == count
