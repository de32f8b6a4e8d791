"""Decides conditions at rising precision, all of them or a random sample."""

import random

from fixed import Undecided, set_precision


class Judge:
    """Called with a condition, the numbers that it is about, the file's `bits`, and what to raise if the condition is not
    certified."""

    def __init__(self, fraction=1.0, seed=0):
        self._fraction = fraction
        self._random = random.Random(seed)
        self.seen = self.checked = 0

    def __call__(self, condition, numbers, bits, wrong):
        self.seen += 1
        if self._random.random() < self._fraction:
            self.checked += 1
            self.always(condition, numbers, bits, wrong)

    @staticmethod
    def always(condition, numbers, bits, wrong):
        """The same, whatever the sample."""
        # Fixed-point numbers: the last attempt has `bits` bits left of a product of three numbers as small as these.
        scale = max(abs(n.numerator.bit_length() - n.denominator.bit_length()) for n in numbers)
        for precision in (96, 256, 2 * bits + 1024 + 3 * scale):
            set_precision(precision)
            try:
                if condition():
                    return
            except Undecided:
                pass
        raise wrong


def ends(box):
    """The numbers of a box."""
    return [end for pair in box.values() for end in pair]
