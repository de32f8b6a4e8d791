"""Where N is not known: the gaps between the closed pieces that know it, U = V. Pieces are (a, b, U or None, V), in ascending order
and without a hole."""

from decimal import ROUND_CEILING, Context, Decimal
from fractions import Fraction

from work import spend

UPWARD = Context(prec=3, rounding=ROUND_CEILING)


def gaps_in(pieces, low, high):
    """The greatest relative width of a gap in [low, high], low < high, and how many there are. Gaps that touch are one, and what is
    known at a single ratio does not divide it."""
    known = [(max(a, low), min(b, high)) for a, b, u, v in pieces if u == v]
    end, widest, number = low, Fraction(0), 0
    for a, b in [*((a, b) for a, b in known if a < b), (high, high)]:
        if a > end:
            spend(1000 + (a.numerator * end.denominator).bit_length() ** 2 // 100)
            widest, number = max(widest, (a - end) / end), number + 1
        end = b
    return widest, number


def widest_text(pieces, low, high):
    """The same as the verdict has it: `0`, or rounded up to 3 digits. Of a single ratio nothing."""
    if low == high:
        return ""
    widest, _ = gaps_in(pieces, low, high)
    digits = f"{UPWARD.divide(Decimal(widest.numerator), Decimal(widest.denominator)):.2e}" if widest else "0"
    return f" widest-gap={digits.replace('+', '')}"


def asked(pieces, low, high):
    """U and V of the pieces that say something of [low, high]; of a single ratio the best of all."""
    if low < high:  # what has no more than an end in common with it says nothing that its neighbour does not
        return [(u, v) for a, b, u, v in pieces if (a < high and b > low if a < b else low <= a <= high)]
    bounds = [(u, v) for a, b, u, v in pieces if a <= low <= b]
    return [(min((u for u, _ in bounds if u is not None), default=None), max(v for _, v in bounds))]


def is_known_but_in_gaps(pieces, low, high, width, number, leap):
    """Is N known in [low, high], but in gaps of at most this relative width, or so many (None: any), where it is one of
    1 + leap neighbours?"""
    bounds = asked(pieces, low, high)
    if low == high:
        return bounds[0][0] == bounds[0][1]
    found = gaps_in(pieces, low, high)
    return (all(u is not None and u <= v + leap for u, v in bounds)
            and (width is None or found[0] <= width) and (number is None or found[1] <= number))
