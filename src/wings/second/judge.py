"""Decides conditions at rising precision."""

from fixed import Undecided, set_precision
from work import spend


def judge(condition, numbers, bits, wrong):
    """Raises `wrong` unless the condition is certified; `numbers` are those that it is about, `bits` is what the file says."""
    # Fixed-point numbers: the last attempt has `bits` bits left of a product of three numbers as small as these.
    sizes = [(n.numerator.bit_length(), n.denominator.bit_length()) for n in numbers]
    scale, longest = max(abs(over - under) for over, under in sizes), max(map(max, sizes))
    for precision in (96, 256, 2 * bits + 1024 + 3 * scale):
        spend(3000 + longest * longest // 100)  # exact fractions, and what becomes of them
        set_precision(precision)
        try:
            if condition():
                return
        except (Undecided, ArithmeticError):  # the second one from guesses, where doubles end
            pass
    raise wrong


def ends(box):
    """The numbers of a box."""
    return [end for pair in box.values() for end in pair]
