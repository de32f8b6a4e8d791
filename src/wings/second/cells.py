"""Scene body, section cells: format-sections.md, section 6; lemmas L86 and L87. A rectangle of bodies, cut into cells, each of which
is bounded by its lower and its upper side."""

from fractions import Fraction

from body import MOST_IN_CORNER, corner_has
from fixed import interval, pi, set_precision, sin_cos, span
from judge import ends
from rays import at_least, at_most, latest, slope_above
from tree import walk
from valley import Valley, contact_from_below
from work import spend


def has(count, rho, q):
    return count > MOST_IN_CORNER or corner_has(count, rho, q)


def over_bridge(ray):
    """The flight to the left, at the next corner."""
    c, kappa = ray
    return c + pi() * kappa, kappa


def outward_from_below(j, p, rho, q):
    """At most Y_j(p), for this rho or lesser ones, this Q or lesser ones; None if it is not followed."""
    valley = Valley(rho, q)
    height = valley.walls[(j + 1) % 2]
    x = contact_from_below(height, interval(p), interval(0))
    if x is None:
        return None
    kappa = (valley.r / (height * sin_cos(x)[1]).upper()).lower()
    ray = (interval(p) + kappa * x).lower(), kappa
    for number in range(j + 1, 2 * j):
        ray = valley.bounce((number + 1) % 2, *ray)[1]
        if ray is None:
            return None
    return ray


def contact_from_above(height, c, kappa):
    """A place behind the contacts of all flights below (c, kappa) with a wall; None if some may miss it."""
    kappa = (kappa / height).upper()
    return latest((c / height).upper(), kappa) if kappa < 1 else None


def outward_from_above(j, p, rho, q):
    """At least Y_j(p), for this rho or greater ones, this Q or greater ones, of which all have it; None if that is not certain."""
    walls, r = (interval(1), interval(rho)), interval(1 / q).upper()
    height = walls[(j + 1) % 2]
    x = contact_from_above(height, interval(p), interval(0))
    if x is None:
        return None
    kappa = (r / (height * sin_cos(x)[1]).lower()).upper()
    ray = (interval(p) + kappa * x).upper(), kappa
    for number in range(j + 1, 2 * j):
        height = walls[(number + 1) % 2]
        x = contact_from_above(height, *ray)
        if x is None:
            return None
        sine, cosine = sin_cos(x)
        kappa = slope_above(height * cosine, ray[1], r)
        if kappa is None:
            return None
        ray = (height * sine + kappa * x).upper(), kappa
    return ray


def orbit_at_most(j, p, rhos, q, most):
    """f(e_j) <= most wherever j <= J; and if p > 0, j <= J for all rho."""
    ray = outward_from_below(j, p, rhos[1], q)
    if ray is None or not at_most(*over_bridge(ray), interval(1 / q), most):
        return False
    if p == 0:
        return True
    ray = outward_from_above(j, p, rhos[0], q)
    return ray is not None and contact_from_above(interval(rhos[0]), *ray) is not None


def no_more(upper, orbits, end, rhos, q):
    """Has none more than `upper`, at Q and all rho?"""
    half = (upper - 1) // 2
    x = [0, *(j for j, _ in orbits), end]
    a = [half + 1 - following for following in x[1:]]
    if min(a) < 0 or any(i >= k for i, k in zip(x, x[1:])):
        return False
    if has(2 * end + 1, rhos[1], q) and not Valley(rhos[1], q).corner_hits_at_most(end - 1):
        return False
    if rhos[0] != 1 and not at_most(interval(rhos[0]), interval(0), interval(1 / q), a[0]):
        return False
    if not all(orbit_at_most(j, p, rhos, q, most) for (j, p), most in zip(orbits, a[1:])):
        return False
    return upper % 2 == 0 or not has(2 * end, rhos[1], q) or Valley(rhos[1], q).even_at_most(end - 1, a[-1] - 1)


def some_have(lower, j, p, rhos, q):
    """Is there a motion with `lower` collisions, at Q and each rho?"""
    r = interval(1 / q)
    if j > 0:
        if p <= 0 or 2 * j >= MOST_IN_CORNER or not corner_has(2 * j + 1, rhos[0], q):
            return False
        ray, low = outward_from_above(j, p, rhos[0], q), outward_from_below(j, p, rhos[1], q)
        return (ray is not None and at_least(*over_bridge(ray), r, max(lower // 2 - j, 0)) and
                low is not None and contact_from_below(interval(rhos[1]), *low) is None)
    if lower <= MOST_IN_CORNER and corner_has(lower, rhos[0], q):
        return True
    if lower % 2:
        return at_least(interval(rhos[1]), interval(0), r, lower // 2)
    slope = slope_above(interval(1), -interval(rhos[0]), r)
    count = lower // 2 - 1
    return (slope is not None and at_least(pi() * rhos[1], interval(rhos[1]), r, count) and
            at_least(pi() * slope, slope, r, count))


def log(x):
    """Encloses the logarithm of a fraction x >= 1: the powers of 2 in it, and 2 atanh(t), t = (x - 1)/(x + 1) <= 1/3, of what is left."""
    doublings = 0
    while x > 2:
        x, doublings = x / 2, doublings + 1
    t = interval((x - 1) / (x + 1))
    power, square, total, n = t, t * t, interval(0), 1
    while power.hi > 1:
        total, power, n = total + power / n, power * square, n + 2
    # What is left out is at most power (1 + t^2 + t^4 + ...) / n <= 9/8 power.
    return span(total, total + power * 2) * 2 + (log(Fraction(2)) * doublings if doublings else 0)


def area(box, asked, root):
    """In (log rho, log Q), of what is asked about in the box; None: nothing. Of a single rho or Q it is the length, and of two boxes
    that share it the upper one has it."""
    spend(20_000)
    set_precision(96)
    size = interval(1)
    for axis, (low, high) in asked.items():
        a, b = max(low, box[axis][0]), min(high, box[axis][1])
        if a >= b if low < high else a > b or b == box[axis][1] < root[axis][1]:
            return None
        if low < high:
            size *= log(Fraction(b) / a)
    return size


def joined(bounds):
    """U, or None, and V of all."""
    uppers, lowers = zip(*bounds or [(None, 0)])
    return None if None in uppers else max(uppers), min(lowers)


def check(lines, judge, demand):
    """Reads the file from its line `ratio` on; returns [R0, R1], the piece [LO, HI] with U (or None) and V of the part that is asked
    about, the same of all, the share of the part that is decided, and the checksum."""
    ratios, rhos = (tuple(lines.line(name, "ratio", "ratio")) for name in ("ratio", "rho"))
    if ratios[0] > ratios[1] or not rhos[0] <= rhos[1] <= 1:
        raise lines.wrong("number", "not LO <= HI and R0 <= R1 <= 1")
    bits, = lines.line("bits", "bits")
    root, asked = {"q": ratios, "rho": rhos}, {"q": demand["inertia"] or ratios, "rho": demand["rho"] or rhos}
    bounds, of_part, known, unknown = [], [], 0, 0

    def leaf(fields, box, _share):
        kind, *values = fields
        if kind in ("open", "beyond") and not values:
            lines.count(kind)
            if kind == "beyond" and box["q"][1] * box["rho"][1] > 1:
                raise lines.wrong(kind, "not certified: R1 B <= 1")
            found(box, None, 0)
            return
        if kind != "cell":
            raise lines.wrong("opcode", "not a line for this place")
        if len(values) < 5 or len(values) % 2 == 0:
            raise lines.wrong("syntax", "expected `cell U V j p end`, and pairs `x p`")
        classes = ["count", "count", "count", "dyadic", "count", *["count", "dyadic"] * (len(values) // 2 - 2)]
        upper, lower, j, p, end, *rest = lines.values(values, *classes)
        lines.count(kind)
        if lower > upper or upper == 0:
            raise lines.wrong("number", "not V <= U, 1 <= U")
        found(box, upper, lower)
        orbits, sides = list(zip(rest[::2], rest[1::2])), box["rho"]
        judge(lambda: no_more(upper, orbits, end, sides, box["q"][1]) and some_have(lower, j, p, sides, box["q"][0]),
              [*ends(box), *(number for number in (p, *rest[1::2]) if number)], bits, lines.wrong(kind, "not certified"))

    def found(box, upper, lower):
        nonlocal known, unknown
        bounds.append((upper, lower))
        size = area(box, asked, root)
        if size is None:
            return
        of_part.append((upper, lower))
        # Above the edge, Q rho = 1; a cell across it counts as a whole.
        if box["q"][0] * box["rho"][0] >= 1 and upper == lower:
            known += size.lo
        elif box["q"][1] * box["rho"][1] > 1:
            unknown += size.hi

    walk(lines, root, leaf)
    source = f"sha256={lines.trailer(['split', 'cell', 'beyond', 'open'])}"
    part = joined(of_part)
    decided = Fraction(1) if part[0] == part[1] else Fraction(known, max(1, known + unknown))
    return rhos, (*ratios, *part), (*ratios, *joined(bounds)), decided, source
