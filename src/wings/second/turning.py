"""Section turning of the scene dumbbell: format.md 3.3 to 3.6, lemmas L8 to L11."""

import math
from fractions import Fraction

from fixed import greatest, half_pi, interval, least, pi, sin_cos
from rays import at_least, at_most

LEAVES = {
    "bridge": {"count": 2, "outside": 0},
    "light": {"count": 2, "outside": 0, "meets": 0, "meets-reversed": 0},
}

def power_of_two(bound):
    """The least 2**k >= bound, k >= 0."""
    return 1 << max(0, (-(-bound.numerator // bound.denominator) - 1).bit_length())


def root(chart, b):
    """The root box but for q; b is the greatest mass ratio of the piece."""
    return {"e": (Fraction(0), Fraction(2)), "eta" if chart == "bridge" else "lambda": (Fraction(0), Fraction(power_of_two(b)))}


def sigma_steepness(eta, s, r):
    """eta' of (3)."""
    base = 1 + r * s * s
    return eta * base / (base + 2 * r * s * eta)


def bridge_sigma(e, eta, r):
    """c/r and lambda of sigma X, with eta' computed at r."""
    sine, s = sin_cos(e)
    steepness = sigma_steepness(eta, s, r) - s
    return sine + steepness * e, steepness


def low_ray_at_most(c, steepness, r, limit):
    """G <= limit for the rays (r' c, r' lambda) at all r' >= r, c and lambda at least the lower ends of these: section 3.5."""
    r = r.lower()
    return limit >= 0 and at_most(r * greatest(c.lower(), 0), r * greatest(steepness.lower(), -1), r, limit)


def bridge_ray_at_most(t, eta, r_lo, limit):
    """At most `limit` collisions of the rays that leave the bridge at t, by eta steeper than its tangent, and of all above them."""
    sine, s = sin_cos(t)
    return low_ray_at_most(sine + (s + eta) * (pi() - t), s + eta, r_lo, limit)


def bridge_leaf(op, hints, box):
    (e0, e1), (eta0, _), (q0, q1) = box["e"], box["eta"], box["q"]
    if op == "outside":
        return interval(e0) > half_pi() or eta0 >= q1
    r_lo, r_hi = interval(1 / q1), interval(1 / q0)
    return bridge_ray_at_most(least(e1, half_pi()), eta0, r_lo, hints[0]) and low_ray_at_most(*bridge_sigma(least(e0, half_pi()), interval(eta0), r_hi), r_lo, hints[1])


def comes_below_bridge(c, steepness, e):
    """Is c + lambda (e + t) < sin t certified for some t in (0, pi)?"""
    t = interval(math.acos(min(max(float(steepness), 0.0), 0.999999)))
    return c + steepness * (e + t) < sin_cos(t)[0]


def light_leaf(op, hints, box):
    (e0, e1), (lambda0, lambda1), (q0, q1) = box["e"], box["lambda"], box["q"]
    r_lo, r_hi = interval(1 / q1), interval(1 / q0)
    at_e1 = least(e1, half_pi())
    sine1, w1 = sin_cos(at_e1)
    if op == "outside":
        return (interval(e0) > half_pi() or lambda0 >= q1
                or interval(e1) < half_pi() and lambda0 * (w1 * w1 - r_hi) > 2 * w1)
    if op == "meets":
        return comes_below_bridge(sine1 / r_lo, interval(lambda1), at_e1)
    if op == "meets-reversed":
        d = w1 * w1 + 2 * r_lo * lambda0 * w1 - r_hi
        mu = (2 * w1 + r_hi * lambda0 - lambda0 * w1 * w1) / (w1 * w1 + 2 * r_hi * lambda0 * w1 - r_hi)
        return d > 0 and comes_below_bridge(sine1 / r_lo, greatest(mu, 0), at_e1)
    e = least(e0, half_pi())
    sine, w = sin_cos(e)
    if not at_most(sine + r_lo * lambda0 * (pi() + e), r_lo * lambda0, r_lo, hints[0]):
        return False
    if w * w + 2 * r_hi * lambda1 * w - r_lo <= 0:
        return True
    d = w * w + 2 * r_lo * lambda1 * w - r_lo
    if not d > 0:
        return False
    kappa = r_lo * greatest((2 * w + r_lo * lambda1 - lambda1 * w * w) / d, 0)
    return at_most(sine + kappa * (pi() + e), kappa, r_lo, hints[1])


def leaf(chart, op, hints, box, _upper):
    """Is the leaf's condition certified at this precision? (1 + a + b <= U is checked elsewhere.)"""
    return (bridge_leaf if chart == "bridge" else light_leaf)(op, hints, box)


def witness(values, q_lo, q_hi):
    """Are the conditions of section 3.6 certified? (1 + a + b >= V is checked elsewhere.)"""
    exact_e, exact_eta, a, b = values
    r_lo, r_hi, e, eta = interval(1 / q_hi), interval(1 / q_lo), interval(exact_e), interval(exact_eta)
    sine, s = sin_cos(e)
    if not (exact_e > 0 and e < half_pi() and exact_eta > 0 and r_hi * (s + eta) < 1):
        return False
    if not bridge_sigma(e, eta, r_hi)[0] > 0:
        return False
    if not at_least(r_hi * (sine + (s + eta) * (pi() - e)), r_hi * (s + eta), r_hi, a):
        return False
    c, steepness = bridge_sigma(e, eta, r_lo)
    if steepness < 0:
        c = least(c, 1)
    return at_least(r_hi * c.upper(), r_hi * steepness.upper(), r_hi, b)


WITNESSES = {"bridge": witness}
COVERS = {"equal-masses": lambda a, b, upper: a == b == 1 and upper >= 2}
