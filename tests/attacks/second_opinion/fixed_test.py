#!/usr/bin/env python3
"""The intervals: known hard cases, and random ones against mpmath at a much higher precision."""

import random
import unittest
from fractions import Fraction

import mpmath

import second

import fixed
from fixed import Undecided, greatest, half_pi, hull, interval, least, meet, pi, point, sin_cos, square

PRECISIONS = 53, 96, 256, 1500


def exact(number):
    """A Fraction as a number of mpmath, whose precision is high enough here."""
    return mpmath.mpf(number.numerator) / number.denominator


def ends(x):
    return Fraction(x.lo, 1 << fixed.precision()), Fraction(x.hi, 1 << fixed.precision())


class Enclosures(unittest.TestCase):
    def each_precision(self):
        for bits in PRECISIONS:
            fixed.set_precision(bits)
            mpmath.mp.prec = 2 * bits + 1200
            yield bits

    def assert_encloses(self, x, value, units, what):
        """x holds the number of mpmath, and is at most so many units of the last place wide."""
        low, high = ends(x)
        self.assertTrue(exact(low) <= value <= exact(high), f"{what} at {fixed.precision()} bits: {value} not in {x.lo} {x.hi}")
        self.assertLessEqual(x.hi - x.lo, units, f"{what} at {fixed.precision()} bits")

    def test_pi(self):
        for _ in self.each_precision():
            self.assert_encloses(half_pi(), mpmath.pi / 2, 2, "pi/2")
        # Archimedes and Zu Chongzhi, which need no library.
        self.assertTrue(interval(Fraction(223, 71)) < pi() and pi() < interval(Fraction(355, 113)))

    def test_sine_and_cosine_near_multiples_of_half_pi(self):
        """Convergents of pi: the fractions nearest to a multiple of pi; and the double nearest to a multiple of pi/2."""
        hard = [Fraction(p, q) for p, q in ((22, 7), (333, 106), (355, 113), (103993, 33102), (104348, 33215),
                                            (5419351, 1725033), (245850922, 78256779), (6167950454, 1963319607))]
        hard += [f / 2 for f in hard] + [Fraction(p) for p in (22, 333, 355, 103993, 104348, 245850922)]
        for bits in self.each_precision():
            for number in hard + [-n for n in hard]:
                sine, cosine = sin_cos(interval(number))
                pad = 4 * bits + 2 * abs(int(number)) + 8
                self.assert_encloses(sine, mpmath.sin(exact(number)), pad, f"sin {number}")
                self.assert_encloses(cosine, mpmath.cos(exact(number)), pad, f"cos {number}")
        fixed.set_precision(1500)
        mpmath.mp.prec = 3000
        cosine = sin_cos(interval(6381956970095103 * 2 ** 797))[1]
        self.assertTrue(-4.687165924254628e-19 < cosine and cosine < -4.687165924254623e-19)
        fixed.set_precision(96)
        for found in sin_cos(interval(6381956970095103 * 2 ** 797)):  # nothing is known of it with so few bits
            self.assertEqual(ends(found), (-1, 1))

    def test_sine_and_cosine_at_small_and_special_numbers(self):
        """z - z^3/6 < sin z < z and 1 - z^2/2 <= cos z <= 1 in exact fractions; the extrema at 0 and pi/2."""
        for bits in self.each_precision():
            for k in (0, 1, 2, 10, bits // 2, bits - 3):
                for m in (1, 3, -1, -3):
                    z = Fraction(m, 2 ** (k + 2))
                    sine, cosine = sin_cos(interval(z))
                    low, high = sorted((z, z - z ** 3 / 6))
                    self.assertTrue(ends(sine)[0] <= high and ends(sine)[1] >= low and ends(cosine)[1] >= 1 - z * z / 2)
                    self.assertTrue(ends(cosine)[1] <= 1)
            sine, cosine = sin_cos(interval(0))
            self.assertTrue(ends(sine)[0] <= 0 <= ends(sine)[1] and ends(cosine)[1] == 1)
            self.assertEqual(ends(sin_cos(half_pi())[0])[1], 1)
            self.assertTrue(ends(sin_cos(half_pi())[1])[0] <= 0 <= ends(sin_cos(half_pi())[1])[1])
            self.assertEqual(ends(sin_cos(pi())[1])[0], -1)

    def test_wide_angles_reach_their_extrema(self):
        for _ in self.each_precision():
            for low, high, sine_range, cosine_range in (
                    (0, 4, (-0.7568, 1), (-1, 1)), (1, 2, (0.8414, 1), (-0.4162, 0.5404)),
                    (3, 4, (-0.7569, 0.1412), (-1, -0.6536)), (-1, 1, (-0.8415, 0.8415), (0.5403, 1)),
                    (-8, -7, (-1, -0.6569), (-0.1456, 0.7540)), (4, 5, (-1, -0.7568), (-0.6537, 0.2837)),
                    (0, 7, (-1, 1), (-1, 1)), (-100, 100, (-1, 1), (-1, 1)), (6, 7, (-0.2795, 0.6570), (0.7539, 1))):
                for found, wanted in zip(sin_cos(hull(low, high)), (sine_range, cosine_range)):
                    found = ends(found)
                    self.assertTrue(abs(found[0] - wanted[0]) < 2e-4 and abs(found[1] - wanted[1]) < 2e-4, (low, high))
                    self.assertTrue(wanted[0] > -1 or found[0] == -1)
                    self.assertTrue(wanted[1] < 1 or found[1] == 1)

    def test_random_angles(self):
        random_numbers = random.Random(1)
        for bits in self.each_precision():
            for _ in range((20 if bits > 1000 else 100) * second.SCALE):
                a = Fraction(random_numbers.randrange(-4 * 10 ** 9, 4 * 10 ** 9), 10 ** random_numbers.randrange(8, 12))
                b = a + Fraction(random_numbers.randrange(10 ** 6), 10 ** random_numbers.randrange(5, 12))
                wide = sin_cos(hull(a, b))
                for number in (a, b, (a + b) / 2, (2 * a + b) / 3):
                    for found, function in zip(wide, (mpmath.sin, mpmath.cos)):
                        value = function(exact(number))
                        self.assertTrue(exact(ends(found)[0]) <= value <= exact(ends(found)[1]), (a, b, number))
                self.assert_encloses(sin_cos(interval(a))[0], mpmath.sin(exact(a)), 8 * bits + 400, f"sin {a}")

    def test_arithmetic(self):
        """Every operation encloses the exact result of every pair of ends, with all signs, and rounds by 2 units at most."""
        random_numbers = random.Random(2)
        for bits in self.each_precision():
            for _ in range(100 * second.SCALE):
                def sample():
                    return point(random_numbers.randrange(-3 << bits, 3 << bits) >> random_numbers.randrange(bits + 2))
                a, b, c, d = sample(), sample(), sample(), sample()
                x, y = hull(a, b), hull(c, d)
                pairs = [(ends(p)[0], ends(q)[0]) for p in (a, b) for q in (c, d)]
                results = [(x + y, [p + q for p, q in pairs]), (x - y, [p - q for p, q in pairs]),
                           (x * y, [p * q for p, q in pairs]), (least(x, y), [min(p, q) for p, q in pairs]),
                           (greatest(x, y), [max(p, q) for p, q in pairs]), (-x, [-p for p, _ in pairs]),
                           (3 * x, [3 * p for p, _ in pairs]), (x * -3, [-3 * p for p, _ in pairs]),
                           (1 - x, [1 - p for p, _ in pairs]), (hull(x, y), [p for pair in pairs for p in pair])]
                if y.lo > 0:
                    results.append((x / y, [p / q for p, q in pairs]))
                else:
                    self.assertRaises(Undecided, lambda: x / y)
                for found, wanted in results:
                    low, high = ends(found)
                    unit = Fraction(2, 1 << bits)
                    self.assertTrue(min(wanted) - unit < low <= min(wanted) and max(wanted) <= high < max(wanted) + unit)
                squares = [p * p for p, _ in pairs] + [Fraction(0)] * (x.lo <= 0 <= x.hi)
                self.assertTrue(0 <= ends(square(x))[0] <= min(squares) or x.lo > 0 or x.hi < 0)
                self.assertTrue(ends(square(x))[1] >= max(squares))

    def test_comparisons_are_certain_or_false(self):
        fixed.set_precision(96)
        one, wide, third = interval(1), hull(0, 2), interval(Fraction(1, 3))
        self.assertFalse(any((wide < 1, wide > 1, wide <= 1, wide >= 1, one < one, third < third, third <= third, third > third)))
        self.assertTrue(one <= one and one >= 1 and hull(-1, 0) <= 0 and third < 1 and 0 < third)
        self.assertTrue(third.lo < third.hi and third * 3 <= interval(1) + point(3) and not third * 3 <= 1)
        self.assertRaises(Undecided, meet, one, interval(2))


if __name__ == "__main__":
    unittest.main()
