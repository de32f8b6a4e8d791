#!/usr/bin/env python3
"""Leaves, witnesses and first contacts that the checker accepts, against a simulation from the model's definition."""

import itertools
import math
import random
import sys
import unittest
from fractions import Fraction

sys.dont_write_bytecode = True

import contact
import fixed
import full
import incoming
import initial
import plain
import turning
import wedge
from grammar import Limit
from simulation import Doubtful, Dumbbell, both_ways, later


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

    def box(self, narrowest=30, **ranges):
        """A random box that begins in these ranges, and is narrow compared with them, more or less."""
        width = 2.0 ** -self.random.randrange(1, narrowest)
        box = {}
        for axis, (low, high) in ranges.items():
            a = Fraction(self.random.uniform(low, high))
            box[axis] = (a, a + Fraction(width * (high - low) * self.random.random()))
        return box

    def points(self, box):
        """The corners of the box, just inside, and one point more."""
        for inside in [*itertools.product((1e-12, 1 - 1e-12), repeat=len(box)), [self.random.random() for _ in box]]:
            yield {axis: float(a + (b - a) * Fraction(share)) for (axis, (a, b)), share in zip(box.items(), inside)}

    def compare(self, module, chart, box, count_of, tightness):
        """The least hints that are certified are not below any simulated count; with a tiny box they are that count."""
        found = []
        for point in self.points(box):
            if point.get("e", 0) > math.pi / 2 or point.get("t", 0) > math.pi:
                continue  # behind the end of the chart
            try:
                found.append(count_of(point))
            except Doubtful:
                pass
        if not found:
            return
        most = tuple(map(max, zip(*found)))
        for hint in range(len(most)):
            if most[hint] > 0:
                hints = [60] * len(most)
                hints[hint] = most[hint] - 1
                self.assertFalse(certified(lambda: module.leaf(chart, "count", hints, box)),
                                 f"{chart} {hints} but {most} in {box}")
        tightness.append(certified(lambda: module.leaf(chart, "count", most, box)))

    def test_formulas(self):
        """The rays of the charts are those of the reflection (1)."""
        fixed.set_precision(96)
        for _ in range(300):
            r, e, eta = self.random.random(), self.random.uniform(0.01, 1.55), self.random.uniform(0.001, 3)
            start = Dumbbell(r, math.pi / 2 - e, r * math.sin(e), (-1.0, r * (math.cos(e) + eta)), 0)
            start.reflect()
            c, steepness = turning.bridge_sigma(*map(fixed.interval, (e, eta, r)))
            slope = -start.velocity[1] / -start.velocity[0]
            self.assertAlmostEqual(r * float(steepness), slope, 11)
            self.assertAlmostEqual(r * float(c), r * math.sin(e) + slope * e, 11)

    def test_outside(self):
        """A box that is called outside has no state of its chart."""
        foreign = {
            (turning, "bridge"): ("e", lambda p: p["e"] > math.pi / 2 or p["eta"] / p["q"] >= 1),
            (turning, "light"): ("e", lambda p: p["e"] > math.pi / 2 or p["lambda"] / p["q"] >= 1
                                 or self.reversed_descends(p)),
            (full, "contact"): ("t", lambda p: p["t"] > math.pi or (p["eta"] - 1) / p["q"] >= 1),
            (full, "departure"): ("e", lambda p: p["e"] > math.pi / 2 or p["eta"] - math.cos(p["e"]) >= 1),
        }
        for (module, chart), (axis, is_foreign) in foreign.items():
            outside = 0
            for _ in range(400):
                q = self.random.choice((1.5, 4, 20))
                second = module.CHARTS[chart][1]
                most = 2 if chart == "departure" else 1.3 * q + 1
                box = self.box(**{axis: (0.01, 1.7 if axis == "e" else 3.3), second: (0.0, most), "q": (q, q * 1.5)})
                if certified(lambda: module.leaf(chart, "outside", [], box)):
                    outside += 1
                    for point in self.points(box):
                        self.assertTrue(is_foreign({k: v * (1 + 1e-9) if k == second else v for k, v in point.items()}), box)
            self.assertGreater(outside, 20, chart)

    @staticmethod
    def reversed_descends(p):
        back = Dumbbell(1 / p["q"], math.pi / 2 + p["e"], math.sin(p["e"]), (-1.0, p["lambda"] / p["q"]), 1)
        back.reflect()
        return back.velocity[1] > 0

    def test_turning(self):
        tightness = []
        for _ in range(250):
            q = self.random.choice((1.5, 4, 20, 300))
            box = self.box(e=(0.01, 1.55), eta=(0.001, min(q - 1, self.random.choice((0.1, 500)))), q=(q, q * 1.5))
            if self.random.random() < 0.4:  # many ratios at one point
                box = {**box, "e": box["e"][:1] * 2, "eta": box["eta"][:1] * 2, "q": (Fraction(q), Fraction(4 * q))}
            if not certified(lambda: turning.leaf("bridge", "outside", [], box)):
                self.compare(turning, "bridge", box, lambda p: both_ways(
                    1 / p["q"], math.pi / 2 - p["e"], 0, (-1.0, (math.cos(p["e"]) + p["eta"]) / p["q"])), tightness)
        self.assertGreater(sum(tightness) / len(tightness), 0.6)

        tightness = []
        for _ in range(250):
            q = self.random.choice((1.5, 4, 20, 300))
            near_bridge = self.random.random() < 0.3
            box = self.box(**{"e": (0.001, 0.1 if near_bridge else 1.55), "lambda": (0.0, 1.0 if near_bridge else q),
                              "q": (q, q * 1.5)})
            dead = any(certified(lambda: turning.leaf("light", op, [], box)) for op in ("outside", "meets", "meets-reversed"))

            def count_of(p):
                start = Dumbbell(1 / p["q"], math.pi / 2 + p["e"], math.sin(p["e"]), (-1.0, p["lambda"] / p["q"]), 1)
                if start.advance() and start.hump == 0 or self.reversed_is_foreign(p):
                    raise Doubtful  # not of this chart
                self.assertFalse(dead and p["lambda"] < p["q"] and p["e"] < math.pi / 2, box)
                return both_ways(1 / p["q"], math.pi / 2 + p["e"], 1, (-1.0, p["lambda"] / p["q"]))
            self.compare(turning, "light", box, count_of, [] if dead else tightness)
        self.assertGreater(sum(tightness) / len(tightness), 0.5)

    @staticmethod
    def reversed_is_foreign(p):
        """Does sigma X meet the bridge, or descend?"""
        back = Dumbbell(1 / p["q"], math.pi / 2 + p["e"], math.sin(p["e"]), (-1.0, p["lambda"] / p["q"]), 1)
        back.reflect()
        back.velocity = -back.velocity[0], -back.velocity[1]
        return back.velocity[1] < 0 or (back.advance() and back.hump == 0)

    def test_full(self):
        for module, boxes, narrowest, least_share in ((full, 200, 30, 0.8), (plain, 200, 30, 0.5), (plain, 600, 7, 0)):
            tightness = []
            for _ in range(boxes):
                q = self.random.choice((1.5, 4, 20, 300))
                wide = q * (1.5 if module is full else 1.1)
                box = self.box(narrowest, t=(0.01, 3.1), eta=(0.001, q + 1), q=(q, wide))
                if not certified(lambda: module.leaf("contact", "outside", [], box)):
                    self.compare(module, "contact", box, lambda p: (later(
                        1 / p["q"], math.pi / 2 - p["t"], 0, (-1.0, (math.cos(p["t"]) + p["eta"]) / p["q"])),), tightness)
                descending = self.random.random() < 0.3
                box = self.box(narrowest, e=(0.01, 0.5 if descending else 1.55), eta=(0.001, 0.4 if descending else 2), q=(q, wide))
                if not certified(lambda: module.leaf("departure", "outside", [], box)):
                    self.compare(module, "departure", box, lambda p: (later(
                        1 / p["q"], math.pi / 2 + p["e"], 1, (-1.0, p["eta"] - math.cos(p["e"]))),), tightness)
            self.assertGreaterEqual(sum(tightness) / len(tightness), least_share, module.__name__)

    def test_once(self):
        """No simulation can refute `once`, as L19 is true: its condition in doubles, with the best z, on large boxes."""
        answers = []
        for _ in range(400):
            q0 = self.random.choice((1, 2, 10, 1000))
            q1, t1, eta0 = q0 * self.random.uniform(1, 2), self.random.uniform(0.1, 4), self.random.choice((0, 0, 0.3))
            eta1 = eta0 + 4 * self.random.random()
            box = {"t": (Fraction(0), Fraction(t1)), "eta": (Fraction(eta0), Fraction(eta1)), "q": (Fraction(q0), Fraction(q1))}
            steepness = math.cos(min(t1, math.pi)) + eta0
            kappa = min(steepness / q0, steepness / q1)
            z = kappa + math.sqrt(kappa * kappa + 1 / q1)
            f = z * (z + 2 / q1) - 1 / q0
            slack = 1 if kappa >= 1 else max(f, (2 + eta1) * f + (z + 1 / q1) / 2)
            if abs(slack) > 1e-6:
                answers.append(slack > 0)
                self.assertEqual(certified(lambda: full.leaf("again", "once", [], box)), slack > 0, box)
        self.assertTrue(30 < sum(answers) < len(answers) - 30, answers)

    def test_witness(self):
        tightness = []
        for _ in range(200):
            q = Fraction(self.random.choice((1.5, 4, 20, 300)))
            e, eta = Fraction(self.random.uniform(0.01, 1.5)), Fraction(self.random.uniform(0.01, float(q) - 1.1))
            try:
                a, b = both_ways(1 / float(q), math.pi / 2 - float(e), 0, (-1.0, (math.cos(e) + float(eta)) / float(q)))
            except Doubtful:
                continue
            for more in ((a + 1, b), (a, b + 1)):
                self.assertFalse(certified(lambda: turning.witness([e, eta, *more], q, q)), (e, eta, q))
            if (math.cos(e) + eta) / q < 1:
                tightness.append(certified(lambda: turning.witness([e, eta, a, b], q, q)))
        self.assertGreater(sum(tightness) / len(tightness), 0.95)

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
        for _ in range(300):
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
        self.assertGreater(refused, 100)

    def test_incoming(self):
        """Pieces of the section of all incoming trajectories; from a greater height they come in with as many collisions."""
        tightness, refused = [], 0
        for _ in range(300):
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
        self.assertGreater(refused, 100)

    def test_no_collision(self):
        certain = 0
        fixed.set_precision(96)
        for _ in range(400):
            q = self.random.choice((1.0, 4, 20))
            box = self.box(q=(q, q * 1.1), phi=(-7, 7), phidot=(-6, 6), y=(0.3, 1.3), ydot=(-0.5, 1.5))
            if initial.above_floor(box) and contact.has_no_collision(contact.Air(box)):
                certain += 1
                self.assertEqual({count for count, _ in self.states(box)} - {0}, set(), box)
        self.assertGreater(certain, 40)

    def test_only_the_first_contact(self):
        """Free flight crosses the floor curve of either mass, some of them twice: only the first crossing of all is one."""
        seen = 0
        fixed.set_precision(96)
        for _ in range(40):
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
        self.assertGreater(seen, 30)

    def test_wedge_in_its_angle(self):
        """atan(sqrt q kappa) grows by gamma with each collision: the number of collisions in closed form."""
        for _ in range(400):
            q = Fraction(self.random.uniform(1.01, 3000))
            kappa = Fraction(self.random.random())
            root = math.sqrt(q)
            gamma = math.atan(2 * root / (q - 1)) if q > 1 else math.pi / 2
            steps = (math.atan(root) - math.atan(root * kappa)) / gamma
            if abs(steps - round(steps)) > 1e-9:
                count = math.ceil(steps)
                self.assertTrue(wedge.count_reaches(kappa, 1 / q, count))
                self.assertFalse(wedge.count_reaches(kappa, 1 / q, count + 1))
        self.assertRaises(Limit, wedge.count_reaches, Fraction(0), Fraction(1, 10 ** 12), 10 ** 6)


if __name__ == "__main__":
    unittest.main()
