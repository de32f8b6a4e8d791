"""Section full: format-sections.md, section 1; lemmas L15, L19."""

import math
from fractions import Fraction

from fixed import greatest, half_pi, interval, least, pi, sin_cos
from rays import at_most, earliest, latest, reflected, slope_above
from turning import COVERS, WITNESSES  # this section's own, too
from turning import bridge_ray_at_most, power_of_two

LEAVES = {
    "contact": {"count": 1, "outside": 0},
    "departure": {"count": 1, "outside": 0},
    "again": {"once": 0, "outside": 0},
}


def root(chart, b):
    if chart == "departure":
        return {"e": (Fraction(0), Fraction(2)), "eta": (Fraction(0), Fraction(2))}
    return {"t": (Fraction(0), Fraction(4)), "eta": (Fraction(0), Fraction(power_of_two(b + 1)))}


def is_outside(chart, box):
    eta0 = box["eta"][0]
    if chart == "departure":
        e0 = interval(box["e"][0])
        return e0 > half_pi() or eta0 - sin_cos(e0)[1] >= 1
    rho = box["rho"][0] if "rho" in box else 1 / box["q"][1]
    return interval(box["t"][0]) > pi() or rho * (eta0 - 1) >= 1


def clears_bridge(h, kappa, r_hi):
    """Is h + kappa t > r sin t certified for all t in [0, pi] and r <= r_hi?"""
    return earliest((h / r_hi).lower(), (kappa / r_hi).lower(), pi()) is None


def steep_time(kappa, r_lo, r_hi):
    """A T at which the bridge of no r in [r_lo, r_hi] is steeper than the rays of slope kappa, certainly; pi if none is found."""
    cosine = min(float(kappa) / float(r_lo), float(kappa) / float(r_hi)) - 1e-12
    if cosine > -1:
        t = interval(math.acos(min(cosine, 1.0)))
        if sin_cos(t)[1] <= least(kappa / r_lo, kappa / r_hi):
            return t
    return pi()


def below_time(h, kappa, r_lo):
    """A T in (0, pi) at which the ray h + kappa t is certainly below the bridge of each r >= r_lo, about the least; None if none
    is found."""
    height, slope, r = float(h), float(kappa), float(r_lo)
    low, high = 0.0, math.acos(min(max(slope / r, -1.0), 1.0))
    for _ in range(60):
        middle = (low + high) / 2
        if r * math.sin(middle) > height + slope * middle:
            high = middle
        else:
            low = middle
    for t in (high + 1e-12, high + 1e-9):
        t = interval(t)
        if 0 < t and t < pi() and h + kappa * t < r_lo * sin_cos(t)[0]:
            return t
    return None


def departure_at_most(box, limit):
    """The two rays `low` and `high`, each a point x and a slope kappa."""
    (e0, e1), (eta0, eta1) = box["e"], box["eta"]
    r_lo, r_hi = interval(1 / box["q"][1]), interval(1 / box["q"][0])
    x, x_high = least(e0, half_pi()).lower(), least(e1, half_pi()).upper()
    (sine, cosine), (sine_high, cosine_high) = sin_cos(x), sin_cos(x_high)
    kappa, kappa_high = (eta0 - cosine).lower(), (eta1 - cosine_high).upper()
    n = 0
    while True:
        if kappa >= 1:
            return True
        c = greatest((sine + kappa * (x + pi())).lower(), 0)
        if kappa >= r_hi:
            return at_most(c, kappa, r_lo, limit - n)
        if not clears_bridge((sine + kappa * x).lower(), kappa, r_hi):
            below = below_time((sine_high + kappa_high * x_high).upper(), kappa_high, r_lo)
            t = steep_time(kappa, r_lo, r_hi)
            if not bridge_ray_at_most(t if below is None or t < below else below, 0, r_lo, limit - n - 1):
                return False
            if below is not None:
                return True
        contact = earliest(c, kappa)
        if contact is None:
            return True
        n += 1
        if n > limit:
            return False
        contact_high = latest(greatest((sine_high + kappa_high * (x_high + pi())).upper(), 0), kappa_high)
        if contact_high is None:
            x_high, sine_high, w = half_pi().upper(), interval(1), greatest(kappa, 0)
        else:
            x_high = contact_high
            sine_high, w = sin_cos(x_high)
        kappa_high = slope_above(w, kappa_high, r_hi)
        kappa_high = interval(1) if kappa_high is None else least(kappa_high, 1)
        if contact_high is None:
            kappa_high = greatest(kappa_high, 0)
        x, (sine, cosine) = contact, sin_cos(contact)
        numerator, d = reflected(cosine.upper(), kappa, r_lo)
        if d <= 0:
            return True
        kappa = (numerator / d).lower()


def once(box):
    """L19: after the contacts of the box the heavy mass is not hit again."""
    eta0, eta1 = box["eta"]
    r_lo, r_hi = interval(1 / box["q"][1]), interval(1 / box["q"][0])
    steepness = sin_cos(least(box["t"][1], pi()))[1] + eta0
    kappa = least(r_lo * steepness, r_hi * steepness).lower()
    if kappa >= 1:
        return True
    guess = float(kappa) + math.sqrt(float(kappa) ** 2 + float(r_lo))
    z = interval(max(guess * (1 - 1e-9), 0.0))
    if not z * z - 2 * kappa * z - r_lo <= 0:
        z = interval(0)
    f = z * (z + 2 * r_lo) - r_hi
    return f >= 0 or (2 + eta1) * f + (z + r_lo) / 2 >= 0


def rays_at_most(chart, box, limit):
    if chart == "contact":
        return bridge_ray_at_most(least(box["t"][1], pi()), box["eta"][0], interval(1 / box["q"][1]), limit)
    return departure_at_most(box, limit)


def leaf(chart, op, hints, box, _upper, count=rays_at_most):
    """Sections differ in how they certify that from no state of a box there are more collisions than a leaf `count` says."""
    if op == "outside":
        return is_outside(chart, box)
    if op == "once":
        return once(box)
    return count(chart, box, hints[0])
