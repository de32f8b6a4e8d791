"""The claim `incoming`: format-initial.md, section 8. All trajectories as they come in, by x = phi / pi and s."""

from fractions import Fraction
from math import isqrt

from fixed import hull
from flight import greatest_number
from initial import check_leaves, leaf_holds, read_ratio
from judge import ends

PI = Fraction(314159265358979323846264338327950288419716939937510, 10**50)  # cut off
DIGIT = Fraction(1, 10**50)
ROOT_BITS = 512


def spins(s, q):
    """Bounds of s sqrt(q / (1 - s^2)), 0 <= s < 1."""
    square = s * s * q / (1 - s * s)
    root = isqrt((square.numerator << 2 * ROOT_BITS) // square.denominator)
    return Fraction(root, 1 << ROOT_BITS), Fraction(root + 1, 1 << ROOT_BITS)


def states(piece, q):
    """The box of states that a piece of the section stands for; s < 1 in it."""
    (x0, x1), (s0, s1) = piece["phi"], piece["s"]
    fall = q / (1 + q)
    return {"q": (q, q), "phi": (PI * x0, (PI + DIGIT) * x1), "phidot": (spins(s0, q)[0], spins(s1, q)[1]),
            "y": (fall * (1 + Fraction(1, 1 << 20)),) * 2, "ydot": (-fall, -fall)}


def check(lines, judge, demand):
    """Checks all after the line `claim`."""
    q, highest = read_ratio(lines)
    if q != highest:
        raise lines.wrong("number", "not LO = HI")

    def holds(piece, low, high, window):
        if piece["s"][1] < 1:
            return leaf_holds(states(piece, q), low, high, window)
        if window is not None or low == high:
            raise lines.wrong("section", "up to s = 1 a leaf is `open`, or `between` without a window")
        return low <= 1 and high >= greatest_number(hull(1 / q))  # they fall, however fast they turn

    def numbers(piece):
        return ends(states(piece, q)) if piece["s"][1] < 1 else [q]

    bits, = lines.line("bits", "bits")
    root = {"phi": (Fraction(0), Fraction(2)), "s": (Fraction(0), Fraction(1))}
    return check_leaves(lines, judge, demand, "incoming", {"ratio": (q, q)}, root, bits, holds, numbers)
