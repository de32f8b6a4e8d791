#!/usr/bin/env python3
"""Contacts and counts of single rays, against bisection in plain doubles; with all signs, and very near to a tangent."""

import math
import random
import unittest
from fractions import Fraction

import second

import fixed
from fixed import half_pi, interval, pi
from rays import at_least, at_most, earliest, greatest_count, latest, least_count, misses


def root(c, kappa, end):
    """The least x of [0, end] with sin x = c + kappa x, None if there is none, and how far from touching the ray is."""
    low, high = 0.0, end
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if math.cos(middle) > kappa else (low, middle)
    height = math.sin(low) - c - kappa * low
    if height <= 0:
        return None, -height
    low, high = 0.0, low
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if math.sin(middle) > c + kappa * middle else (middle, high)
    return low, height


def count(c, kappa, r):
    """G, or None if doubles cannot tell."""
    collisions = 0
    while kappa < 1:
        x, distance = root(c, kappa, math.pi / 2)
        if distance < 1e-9:
            return None
        if x is None:
            break
        collisions += 1
        w = math.cos(x)
        d = w * w - 2 * kappa * w - r
        if abs(d) < 1e-9:
            return None
        if d < 0:
            break
        kappa = (kappa * w * w + 2 * r * w - r * kappa) / d
        c = math.sin(x) + kappa * (x + math.pi)
    return collisions


class SingleRays(unittest.TestCase):
    def test_contacts(self):
        chance = random.Random(3)
        for bits in (53, 96, 256):
            fixed.set_precision(bits)
            for _ in range(1500):
                end = chance.choice((half_pi(), pi()))
                c, kappa = interval(chance.uniform(0, 1.5) ** 2).lower(), interval(chance.uniform(-2, 1.2)).lower()
                x, distance = root(float(c), float(kappa), float(end))
                early, late = earliest(c, kappa, end), latest(c, kappa, end)
                if distance < 1e-7:
                    continue
                if x is None:
                    self.assertTrue(early is None and late is None and misses(c, kappa, end), (c.lo, kappa.lo))
                else:
                    self.assertTrue(x - 1e-8 < float(early) < x + 1e-14 and x - 1e-14 < float(late) < x + 1e-8, (c.lo, kappa.lo))
                    self.assertFalse(misses(c, kappa, end))
                    self.assertLess(early.lo, late.lo)

    def test_near_a_tangent(self):
        """A ray 10^-n above or below the tangent of the wall at z, at a precision that sees it."""
        for bits, n in ((96, 20), (256, 50), (1500, 300)):
            fixed.set_precision(bits)
            for z in (Fraction(1, 3), Fraction(1), Fraction(3, 2)):
                sine, kappa = fixed.sin_cos(interval(z))
                tangent = sine - kappa.lower() * z
                above, below = (tangent + Fraction(1, 10 ** n)).upper(), (tangent - Fraction(1, 10 ** n)).lower()
                self.assertTrue(misses(above, kappa.lower(), half_pi()) and latest(above, kappa.lower()) is None)
                self.assertIsNone(earliest(above, kappa.lower()))
                self.assertFalse(misses(below, kappa.lower(), half_pi()))
                early, late = earliest(below, kappa.lower()), latest(below, kappa.lower())
                away = math.sqrt(2 / math.sin(z)) * 10 ** (-n / 2)  # the contact's distance from z
                for found in early, late:
                    self.assertAlmostEqual(float(z - found) / away if away > 1e-140 else 1, 1, 2)

    def test_counts(self):
        chance, certain, seen = random.Random(4), 0, 0
        fixed.set_precision(96)
        for _ in range(700):
            r = chance.choice((1, 0.3, 0.01, 0.0003))
            c, kappa, r = interval(chance.random() ** 3).lower(), interval(chance.uniform(-r, 1)).lower(), interval(r).lower()
            exact = count(float(c), float(kappa), float(r))
            if exact is None:
                continue
            seen += 1
            most, least = greatest_count(c, kappa, r, 1000), least_count(c, kappa, r, 1000)
            self.assertTrue(least <= exact <= most, (c.lo, kappa.lo, r.lo))
            certain += most == least
            self.assertEqual([at_most(c, kappa, r, exact - 1), at_least(c, kappa, r, exact + 1)], [False, False])
            self.assertTrue(most != least or at_most(c, kappa, r, exact) and at_least(c, kappa, r, exact))
        self.assertGreater(certain, 0.999 * seen)

    def test_counts_where_they_change(self):
        """A c at which the count changes is found by bisection: 10^-7 on both sides of it the counts are still exact."""
        chance, seen = random.Random(6), 0
        fixed.set_precision(96)
        for _ in range(200):
            r = chance.choice((0.3, 0.05, 0.01))
            kappa, low, high = chance.uniform(-r, 0.5), 0.0, chance.random()
            many, few = count(low, kappa, r), count(high, kappa, r)
            while many is not None and few is not None and many > few and high - low > 1e-11:
                middle = (low + high) / 2
                found = count(middle, kappa, r)
                if found is None or found == few:
                    high = middle
                else:
                    low, many = middle, found
            if high - low > 1e-11:
                continue
            for c in (low - 1e-7, high + 1e-7):
                exact, ray = count(c, kappa, r), [interval(number) for number in (c, kappa, r)]
                if c > 0 and exact is not None:
                    seen += 1
                    self.assertEqual([greatest_count(*ray, 1000), least_count(*ray, 1000)], [exact, exact], (c, kappa, r))
        self.assertGreater(seen, 40)


if __name__ == "__main__":
    unittest.main()
