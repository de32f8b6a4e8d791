"""Scenes wedge and hybrid: format-sections.md, section 3; lemmas L17, L18. All in exact rational numbers."""

from fractions import Fraction

from turning import power_of_two
from work import spend

LEAVES = {"wedge": {"count": 2, "outside": 0}}
COVERS = {}


def root(chart, b):
    return {"lambda": (Fraction(0), Fraction(power_of_two(b)))}


def count_reaches(kappa, r, count):
    """Is G_w(kappa, r) >= count? kappa = n/m is followed as a pair of integers, m > 0."""
    (n, m), (over, under) = kappa.as_integer_ratio(), r.as_integer_ratio()
    for _ in range(count):
        spend(500 + m.bit_length() * under.bit_length() // 230)
        if n >= m:
            return False
        n, m = n * under + 2 * over * m - over * n, m * under - 2 * n * under - over * m
        if m <= 0:  # D <= 0: this collision is the last
            n, m = 1, 1
    return True


def sigma_slope(steepness, r):
    """Numerator and denominator of mu."""
    return 2 + r * steepness - steepness, 1 + 2 * r * steepness - r


def leaf(chart, op, hints, box, _upper):
    (lambda0, lambda1), (q0, q1) = box["lambda"], box["q"]
    r_lo, r_hi = 1 / q1, 1 / q0
    if op == "outside":
        return r_lo * lambda0 >= 1 or lambda0 * (1 - r_hi) > 2
    numerator, d = sigma_slope(lambda1, r_lo)
    mu = numerator / d if numerator > 0 and d > 0 else Fraction(0)
    return not (count_reaches(r_lo * lambda0, r_lo, hints[0] + 1) or count_reaches(r_lo * mu, r_lo, hints[1] + 1))


def witness(values, q_lo, q_hi):
    zero, steepness, a, b = values
    r_lo, r_hi = 1 / q_hi, 1 / q_lo
    if zero != 0 or r_hi * steepness >= 1 or any(d <= 0 or numerator < 0 for numerator, d in
                                    (sigma_slope(steepness, r_lo), sigma_slope(steepness, r_hi))):
        return False
    numerator, d = sigma_slope(steepness, r_hi)
    return count_reaches(r_hi * steepness, r_hi, a) and count_reaches(r_hi * numerator / d, r_hi, b)


WITNESSES = {"wedge": witness}
