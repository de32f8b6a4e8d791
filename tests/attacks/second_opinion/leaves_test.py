#!/usr/bin/env python3
"""Leaves about starts and first contacts that the checker accepts, against a simulation from the model's definition."""

import itertools
import math
import random
import unittest
from fractions import Fraction

import second

import body
import contact
import fixed
import incoming
import initial
from simulation import Doubtful, Dumbbell


def certified(condition):
    for bits in (96, 256):
        fixed.set_precision(bits)
        try:
            if condition():
                return True
        except fixed.Undecided:
            pass
    return False


class Leaves(unittest.TestCase):
    def setUp(self):
        self.random = random.Random(5)

    def box(self, **ranges):
        """A random box that begins in these ranges, and is narrow compared with them, more or less."""
        width = 2.0 ** -self.random.randrange(1, 30)
        box = {}
        for axis, (low, high) in ranges.items():
            a = Fraction(self.random.uniform(low, high))
            box[axis] = (a, a + Fraction(width * (high - low) * self.random.random()))
        return box

    def points(self, box):
        """The corners of the box, just inside, and one point more."""
        for inside in [*itertools.product((1e-12, 1 - 1e-12), repeat=len(box)), [self.random.random() for _ in box]]:
            yield {axis: float(a + (b - a) * Fraction(share)) for (axis, (a, b)), share in zip(box.items(), inside)}

    def states(self, box):
        """Simulated collisions of the corners of a box of initial conditions: number, time and hump of the first."""
        for p in self.points(box):
            stretch = 1 + 1 / p["q"]
            try:
                yield Dumbbell(1 / p["q"], p["phi"] - math.pi / 2, p["y"] * stretch,
                               (p["phidot"], p["ydot"] * stretch)).collisions()
            except Doubtful:
                pass

    @staticmethod
    def window(firsts):
        """A window of first contacts, or None if there are none, or of both masses."""
        if None in firsts or len({hump % 2 for _, hump in firsts}) != 1:
            return None
        times = [Fraction(time) for time, _ in firsts]
        return "light" if firsts[0][1] % 2 else "heavy", min(times) - Fraction(1, 10 ** 6), max(times) + Fraction(1, 10 ** 6)

    def test_initial_conditions(self):
        tightness, refused = [], 0
        for _ in range(100 * second.SCALE):
            q = self.random.choice((1.0, 4, 20, 300))
            box = self.box(q=(q, q * 1.1), phi=(-7, 7), phidot=(-2, 2), y=(1.1, 2), ydot=(-1, 0.7))
            found = list(self.states(box))
            if not found:
                continue
            counts, window = {count for count, _ in found}, self.window([first for _, first in found])
            for count in counts | {min(counts) - 1, max(counts) + 1}:
                if count >= 0 and (count > 0) == (window is not None):
                    holds = certified(lambda: initial.leaf_holds(box, count, count, window))
                    if counts == {count}:
                        tightness.append(holds)
                    else:
                        refused += 1
                        self.assertFalse(holds, (box, counts, count))
            if window:
                mass, t0, t1 = window
                for wrong in ((mass, t1, 2 * t1 - t0), (mass, t0 / 2, t0), ("light" if mass == "heavy" else "heavy", t0, t1)):
                    self.assertFalse(certified(lambda: initial.leaf_holds(box, 1, 10 ** 9, wrong)), (box, wrong))
        self.assertGreater(sum(tightness) / len(tightness), 0.7)
        self.assertGreater(refused, 100 * second.SCALE // 3)

    def test_incoming(self):
        """Pieces of the section of all incoming trajectories; from a greater height they come in with as many collisions."""
        tightness, refused = [], 0
        for _ in range(100 * second.SCALE):
            q = Fraction(self.random.choice((1.0, 4, 20, 300)))
            piece = self.box(phi=(0, 1.9), s=(0, 0.65))
            states = incoming.states(piece, q)
            found = set()
            for p in self.points(piece):
                angle, spin = math.pi * p["phi"], p["s"] * math.sqrt(q / (1 - p["s"] ** 2))
                for axis, value in (("phi", angle), ("phidot", spin)):
                    low, high = states[axis]
                    self.assertTrue(low - 1e-13 < value < high + 1e-13, (piece, axis))
                try:
                    start = Dumbbell(1 / float(q), angle - spin - math.pi / 2, 2 + 2.0 ** -20, (spin, -1.0))
                    found.add(start.collisions())
                except Doubtful:
                    pass
            window = self.window([(time - 1, hump) for _, (time, hump) in found]) if found else None
            if window is None or window[1] <= 0:
                continue
            counts = {count for count, _ in found}
            for count in counts | {min(counts) + 1, max(counts) + 1}:
                holds = certified(lambda: initial.leaf_holds(states, count, count, window))
                if counts == {count}:
                    tightness.append(holds)
                else:
                    refused += 1
                    self.assertFalse(holds, (piece, counts, count))
        self.assertGreater(sum(tightness) / len(tightness), 0.7)
        self.assertGreater(refused, 100 * second.SCALE // 3)

    def test_bodies(self):
        """Collision states of rods, without mass, too, and witnesses: their later collisions, and those before."""
        tightness, refused = [], 0
        for _ in range(200 * second.SCALE):
            q, rho = Fraction(self.random.choice((2, 3, 4, 9, 30))), Fraction(self.random.choice((1, 2, 3, 11)))
            massless = self.random.random() < 0.2
            rho = 1 / q if massless else min(Fraction(1), rho * Fraction(11, 10) / q)
            section, r, height = body.Bodies((rho, rho)), float(1 / q), float(rho)

            def later(p, turned=False):
                """Of a contact or a departure; `turned`: of the motion before it."""
                x, is_contact = p.get("t", p.get("e")), "t" in p
                psi, y = (math.pi / 2 - x, height * math.sin(x)) if is_contact else (math.pi / 2 + x, math.sin(x))
                slope = height * (math.cos(x) + p["eta"]) if is_contact else p["eta"] - math.cos(x)
                state = Dumbbell(r, psi, y, (-1, slope), 0 if is_contact else 1, height)
                if turned:
                    state.reflect()
                    state.velocity = -state.velocity[0], -state.velocity[1]
                return state.collisions()[0]

            chart, axis, end = self.random.choice((("contact", "t", 3.1), ("departure", "e", 1.5)))
            box = {**self.box(**{axis: (0.01, end), "eta": (0.001, float(1 / rho) if axis == "t" else 1)}), "q": (q, q), "rho": (rho, rho)}
            try:
                counts = {later(p) for p in self.points(box)}
            except Doubtful:
                continue
            most = max(counts)
            if massless:
                del box["rho"]  # the section plain
            tightness.append(certified(lambda: section.leaf(chart, "count", [most], box, None)))
            if most > 0:
                refused += 1
                self.assertFalse(certified(lambda: section.leaf(chart, "count", [most - 1], box, None)), (q, rho, box))
            e, eta = box[axis][0], box["eta"][0]
            if axis == "e" or e > 1.5:
                continue
            try:
                p = {"t": float(e), "eta": float(eta)}
                forward, backward = later(p), later(p, turned=True)
            except Doubtful:
                continue
            tightness.append(certified(lambda: section.from_bridge((e, eta, forward, backward), q, q)))
            for wrong in ((forward + 1, backward), (forward, backward + 1)):
                self.assertFalse(certified(lambda: section.from_bridge((e, eta, *wrong), q, q)), (q, rho, e, eta, wrong))
        self.assertGreater(sum(tightness) / len(tightness), 0.7)
        self.assertGreater(refused, 50 * second.SCALE)

    def test_a_slope_in_its_other_forms(self):
        """Of L4, over a box of a body in which the denominator may vanish: its one form alone is not enough."""
        half = Fraction(1, 2)
        box = {"t": (Fraction(5, 4), Fraction(11, 8)), "eta": (Fraction(0), Fraction(1, 16)), "q": (Fraction(3), Fraction(3)),
               "rho": (half, half)}
        self.assertTrue(certified(lambda: body.Bodies((half, half)).leaf("contact", "count", [1], box, None)))

    def test_no_collision(self):
        certain = 0
        fixed.set_precision(96)
        for _ in range(80 * second.SCALE):
            q = self.random.choice((1.0, 4, 20))
            box = self.box(q=(q, q * 1.1), phi=(-7, 7), phidot=(-6, 6), y=(0.3, 1.3), ydot=(-0.5, 1.5))
            if initial.above_floor(box) and contact.has_no_collision(contact.Air(box)):
                certain += 1
                self.assertEqual({count for count, _ in self.states(box)} - {0}, set(), box)
        self.assertGreater(certain, 8 * second.SCALE)

    def test_only_the_first_contact(self):
        """Free flight crosses the floor curve of either mass, some of them twice: only the first crossing of all is one."""
        seen = 0
        fixed.set_precision(96)
        for _ in range(12 * second.SCALE):
            q = self.random.choice((1.0, 4, 20))
            state = {axis: self.random.uniform(*ends) for axis, ends in
                     (("phi", (-7, 7)), ("phidot", (-6, 6)), ("y", (1.05, 2)), ("ydot", (-1, -0.1)))}
            h, v, w = state["y"] * (1 + 1 / q), state["ydot"] * (1 + 1 / q), state["phidot"]
            crossings = []
            for mass, size in (("light", -1), ("heavy", 1 / q)):
                def clearance(t):
                    return h + v * t - size * math.sin(state["phi"] + w * t)
                times = [0.003 * k for k in range(1500)]
                crossings += [(t, mass) for t in times if clearance(t) > 0 > clearance(t + 0.003)]
            box = {axis: (Fraction(number),) * 2 for axis, number in [("q", q), *state.items()]}
            for number, (t, mass) in enumerate(sorted(crossings)):
                seen += number > 0
                t0, t1 = (Fraction(t) if t > 0 else Fraction(1, 10 ** 9)), Fraction(t + 0.003)
                first = contact.is_first_contact(contact.Air(box), mass, t0, t1)
                self.assertFalse(first and number > 0, (state, t, mass))
                if number == 0 and len(crossings) > 2:  # the light mass goes down, up and down again in between
                    last = Fraction(max(t for t, other in crossings if other == mass) + 0.003)
                    self.assertFalse(last > t1 and contact.is_first_contact(contact.Air(box), mass, t0, last), (state, t, mass))
        self.assertGreater(seen, 8 * second.SCALE)


if __name__ == "__main__":
    unittest.main()
