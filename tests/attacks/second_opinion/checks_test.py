#!/usr/bin/env python3
"""Each check without which a bound would be none, and each count of work, is needed: taken out of the source, it is missed.

Rows: a module; a part of its text; what it becomes; what is true no more then, at 96 bits."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import second

BEFORE = """
import body, contact, fixed, flight, full, grammar, judge, rays, tree, work
from fixed import *
from rays import *
from fractions import Fraction

def refuses(function, *arguments):
    try:
        function(*arguments)
    except (Undecided, ValueError, TypeError):
        return True

def struck(phi):
    # The rays after a fall to the light mass's peak, at about this angle.
    box = {"phi": phi, "phidot": (2, 2), "y": (0.505, 0.505), "ydot": (-0.5, -0.5), "q": (1, 1)}
    return flight.first_reflection(contact.Air(box), "light", hull(0.001, 0.02))

def within(a, k, low, high):
    return flight.counts_within(flight.Rays("bridge", a, k, one), low, high)

def cost(function):
    work.allow(1000)
    function()
    return 1000 * work.UNITS_PER_SECOND - work._left

long = Fraction(1, 10 ** 2000)
"""
EACH = """
set_precision(96)
zero, half, one, two, four = map(interval, (0, 0.5, 1, 2, 4))
assert """
DOMAIN = "(c >= 0 and kappa >= -r and r > 0)", "(c >= 0 and kappa >= -r)"
CHECKS = (
    ("fixed", "if c <= 0:", "if c <= 0 <= d:", "earliest(point(33913), point(79228162514264332888819981598)) is not None"),
    ("fixed", "Interval.lo = Interval.hi = property(_outlived)", "pass", 
     "not set_precision(256) and all(refuses(eval, text, {**globals()}) for text in ('one + 1', '1 - one', 'one < 2', 'meet(one, 1)'))"),
    ("fixed", "if low.lo > high.hi:", "if False:", "refuses(span, two, one)"),
    ("fixed", "a.lo > b.hi or ", "", "refuses(meet, two, one)"),
    ("fixed", " or b.lo > a.hi", "", "refuses(meet, one, two)"),
    ("fixed", "not 0 <= z <= 2 << _bits", "z < 0", "refuses(fixed._sin_cos_number, 3 << 96)"),
    ("fixed", "not 0 <= z <= 2 << _bits", "z > 2 << _bits", "refuses(fixed._sin_cos_number, -1)"),
    ("rays", "0 <= z.lo and ", "", "refuses(rays._tangent, point(-1), pi())"),
    ("rays", "z.hi <= end.lo and ", "", "refuses(rays._tangent, four, pi())"),
    ("rays", " and end.hi <= pi().hi", "", "refuses(rays._tangent, one, four)"),
    ("rays", "return c - sine + z * cosine > 0 and ", "return ", "not misses(-one, four, half_pi())"),
    ("rays", " and c + kappa * end - sine - (end - z) * cosine > 0", "", "not misses(two, -two, half_pi())"),
    ("rays", "if not c >= 0:", "if False:", "refuses(latest, -one, zero)"),
    ("rays", " and sin_cos(x)[0] > c + kappa * x", "", "latest(two, zero) is None"),
    ("rays", "w > 0 and d > 0", "d > 0", "slope_above(point(-5), half, point(1)) is None"),
    ("rays", DOMAIN[0], "(kappa >= -r and r > 0)", "refuses(greatest_count, -one, zero, one, 9)"),
    ("rays", DOMAIN[0], "(c >= 0 and r > 0)", "refuses(greatest_count, zero, -two, one, 9)"),
    ("rays", DOMAIN[0], DOMAIN[1], "refuses(greatest_count, zero, zero, zero, 9)"),
    ("rays", DOMAIN[1], "(kappa >= -r)", "refuses(least_count, -one, one, one, 9)"),
    ("rays", DOMAIN[1], "(c >= 0)", "refuses(least_count, two, -two, one, 9)"),
    ("full", "t < pi() and h + kappa * t < r_lo * sin_cos(t)[0]", "t < pi()", "full.below_time(two, zero, one) is None"),
    ("full", "sin_cos(t)[1] <= least(kappa / r_lo, kappa / r_hi)", "True", "full.steep_time(one, *[hull(1, 3)] * 2).lo == pi().lo"),
    ("flight", "if not c > 0:", "if False:", "refuses(flight.Rays('bridge', zero, zero, one)._contact, zero, zero, half_pi())"),
    ("flight", "if not (number > 0 or number < 0):", "if False:", "refuses(flight.sign, hull(-1, 1), '')"),
    ("flight", "if not (angle > peak or angle < peak):", "if False:", "refuses(struck, (-1.6, -1.54))"),
    ("flight", "if (angle > peak) != (onward > 0):", "if False:", "struck((-1.62, -1.62)) is None"),
    ("flight", "(low is None or n + 1 >= low)", "True", "not within(half, zero, 2, None)"),
    ("flight", "(high is None or n + 1 <= high)", "True", "not within(half, zero, None, 0)"),
    ("body", "if not top > 0:", "if False:", "refuses(body.quotient, hull(-1, 1), hull(-1, 1))"),
    ("body", "q[0] * rho[0] == q[1] * rho[1] == 1", "q[0] * rho[0] == 1", "not body.Body((2, 3), (0.5, 0.5)).massless"),
    ("fixed", "    spend(2000)\n", "", "cost(lambda: [set_precision(96 + k % 2) for k in range(1000)]) > 10 ** 6"),
    ("fixed", "spend(3000 + 30 * bits + bits * bits // 50)", "pass", "cost(lambda: set_precision(9216)) > 10 ** 6"),
    ("fixed", "    if bits not in kept:", "    if True:", "cost(lambda: [set_precision(9216 + k % 2) for k in range(100)]) < 10 ** 7"),
    ("fixed", "            kept.clear()\n", "            pass\n", "[set_precision(96 + k) for k in range(100)] and len(work.kept) <= 64"),
    ("work", "    kept.clear()\n", "", "cost(lambda: set_precision(999)) == cost(lambda: set_precision(999))"),
    ("fixed", "    spend(10 * _term_cost)\n", "    pass\n", "cost(lambda: sin_cos(hull(0, 7))) > 0"),
    ("fixed", "    spend(k * _term_cost)\n", "", "cost(lambda: sin_cos(one)) > 0"),
    ("grammar", "spend(1500 + 30 * len(line))", "pass", "cost(grammar.Lines(b'a' * 4000 + b'\\n').next) > 10 ** 5"),
    ("tree", "spend(1000 + 2 * halvings)", "pass", "cost(lambda: tree.walk(grammar.Lines(b'open\\n'), {}, lambda *_: 0)) > 2000"),
    ("tree", "spend(1000 + bits * bits // 1000)", "pass",
     "cost(lambda: tree.walk(grammar.Lines(b'split q\\nopen\\nopen\\n'), {'q': (long, 2 * long)}, lambda *_: 0)) > 4 * 10 ** 4"),
    ("judge", "spend(3000 + longest * longest // 100)", "pass", "cost(lambda: judge.judge(lambda: True, [long], 53, None)) > 10 ** 5"),
)


class Checks(unittest.TestCase):
    def complaint(self, folder, *statements):
        asked = BEFORE + "".join(EACH + statement for statement in statements)
        return subprocess.run([sys.executable, "-Bc", asked], cwd=folder, stderr=subprocess.PIPE, text=True, check=False).stderr

    def test_all_hold(self):
        self.assertEqual(self.complaint(second.FOLDER, *(row[3] for row in CHECKS)), "")

    def test_none_is_superfluous(self):
        for module, check, instead, statement in CHECKS:
            with self.subTest(module=module, check=check, instead=instead), tempfile.TemporaryDirectory() as parent:
                file = Path(shutil.copytree(second.FOLDER, f"{parent}/second")) / f"{module}.py"
                text = file.read_text()
                self.assertEqual(text.count(check), 1)
                file.write_text(text.replace(check, instead))
                self.assertIn("AssertionError", self.complaint(file.parent, statement))


if __name__ == "__main__":
    unittest.main()
