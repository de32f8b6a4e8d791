"""Section plain: format-sections.md, section 2; lemma L16. States are carried as intervals."""

from fixed import Undecided, greatest, half_pi, interval, least, meet, pi, sin_cos, span, square
from full import CHARTS, COVERS, LEAVES, WITNESSES, root  # this section's own, too
from full import below_time, is_outside, once, steep_time
from rays import earliest, latest, reflected


def returning(slope):
    """Slopes that may come back: at most 1 (L3); None if there are none."""
    return None if slope >= 1 else least(slope, 1)


def new_slope(w, kappa, r):
    """Encloses the slopes after a light wall that may come back; None if it is certain that none does."""
    numerator, d = reflected(w, kappa, r)
    numerator = meet(numerator, kappa * (square(w) - r) + 2 * r * w)
    d = meet(d, w * (w - 2 * kappa) - r)
    if d <= 0:
        return None
    if not d > 0:
        if not numerator > 0:
            raise Undecided("the reflected direction")
        flattest = numerator.lower() / d.upper()
        return returning(span(flattest, greatest(flattest, 1)))
    slope = numerator / d
    if w > 0:
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


def plain_at_most(c, kappa, r, limit):
    """At most `limit` collisions of the rays (c, kappa); the bridge is out of reach."""
    kappa = returning(kappa)
    while kappa is not None and limit >= 0:
        hit = wall(c, kappa, r)
        if hit is None:
            return True
        limit -= 1
        if limit < 0:
            return False
        x, sine, kappa = hit
        if kappa is not None:
            c = sine + kappa * (x + pi())
    return limit >= 0


def behind_bridge_at_most(t, kappa, r, limit):
    """At most `limit` collisions after a contact with the bridge in t."""
    sine, s = sin_cos(t)
    base = r * square(s)
    e, p = 1 + 2 * s * kappa - base, 2 * r * s - kappa * (1 - base)
    for side in (1, -1):  # to the left if E > 0, to the right if E < 0
        speed = side * e
        if speed <= 0:
            continue
        if speed > 0:
            slope = p / speed
        elif p > 0:
            flattest = p.lower() / speed.upper()
            slope = span(flattest, greatest(flattest, 1))
        else:
            raise Undecided("the direction behind the bridge")
        if not plain_at_most(r * sine + slope * (pi() - t if side > 0 else t), slope, r, limit):
            return False
    return limit >= 0


def departure_at_most(x, sine, kappa, r, limit):
    n, r_lo, r_hi = 0, r.lower(), r.upper()
    kappa = returning(kappa)
    while kappa is not None:
        h = greatest(sine + kappa * x, 0)
        first = None if kappa >= r_hi else earliest((h / r_hi).lower(), (kappa / r_hi).lower(), pi())
        if first is not None:
            below = below_time(h.upper(), kappa.upper(), r_lo)
            latest_contact = steep_time(kappa.lower(), r_lo, r_hi)
            if below is not None:
                latest_contact = least(latest_contact, below)
            if not behind_bridge_at_most(span(first, greatest(latest_contact, first)), kappa, r, limit - n - 1):
                return False
            if below is not None:
                return True
        hit = wall(sine + kappa * (x + pi()), kappa, r)
        if hit is None:
            return True
        n += 1
        if n > limit:
            return False
        x, sine, kappa = hit
    return True


def leaf(chart, op, hints, box):
    if op == "outside":
        return is_outside(chart, box)
    if op == "once":
        return once(box)
    r, (eta0, eta1) = span(interval(1 / box["q"][1]), interval(1 / box["q"][0])), box["eta"]
    eta = span(interval(eta0), interval(eta1))
    if chart == "contact":
        t = span(least(box["t"][0], pi()), least(box["t"][1], pi()))
        sine, cosine = sin_cos(t)
        return plain_at_most(r * (sine + (cosine + eta) * (pi() - t)), r * (cosine + eta), r, hints[0])
    e = span(least(box["e"][0], half_pi()), least(box["e"][1], half_pi()))
    sine, cosine = sin_cos(e)
    return departure_at_most(e, sine, eta - cosine, r, hints[0])
