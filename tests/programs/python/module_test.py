#!/usr/bin/env python3
"""The installed module dumbbell: what it takes and gives, its docstrings and its chapter, Ctrl-C, threads, stubs."""
import ast
import doctest
import gzip
import math
import os
import re
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import dumbbell
import numpy
from dumbbell import _dumbbell

ROOT = Path(__file__).resolve().parents[3]
TEN = (ROOT / "certificates/q-10.dbc").read_bytes()


def examples_of(page):
    """What a page shows of Python."""
    text = re.sub(r"^```.*$", "", page.read_text(), flags=re.M)
    return doctest.DocTestParser().get_doctest(text, {}, page.name, str(page), 0)


def load_tests(loader, tests, pattern):
    for suite in (doctest.DocTestSuite(_dumbbell), doctest.DocTestSuite(dumbbell),
                  unittest.TestSuite([doctest.DocTestCase(examples_of(ROOT / "docs/13-python.md"))])):
        assert suite.countTestCases() > 0
        tests.addTests(suite)
    return tests


class WhatGoesIn(unittest.TestCase):
    def test_all_that_is_exactly_ten_is_ten(self):
        for ten in (10, 10.0, "10", "1e1", Fraction(10), Decimal(10), (10, 10), numpy.int64(10), numpy.float32(10)):
            self.assertEqual(dumbbell.certify(ten).bytes, TEN)

    def test_a_float_is_its_exact_value(self):
        self.assertEqual(dumbbell.certify(4.6).ratio[0], Fraction(4.6))
        self.assertEqual(dumbbell.certify("4.6").ratio[0], Fraction(46, 10))
        self.assertEqual(dumbbell.certify(math.ulp(1.0)).ratio[0], 2**52)

    def test_what_is_no_number_is_refused(self):
        for what in (None, True, [10], 1j, b"10", (1, 2, 3)):
            self.assertRaises(TypeError, dumbbell.certify, what)
        for what in ("ten", "", 0, -1, "2:1", (1, float("nan")), 10**1001):
            self.assertRaises(ValueError, dumbbell.certify, what)
        self.assertRaises(OverflowError, dumbbell.certify, math.inf)

    def test_a_mistake_is_said_in_a_sentence_of_the_program(self):
        with self.assertRaisesRegex(dumbbell.InputError, "the range '2:1' is reversed: write the smaller ratio first"):
            dumbbell.certify("2:1")
        with self.assertRaisesRegex(ValueError, "there is no critical ratio for N = 2"):
            dumbbell.critical(2)
        with self.assertRaisesRegex(ValueError, "are too many"):
            dumbbell.critical(10**40)
        self.assertRaises(ValueError, dumbbell.certify, 10, section="half")
        self.assertRaises(ValueError, dumbbell.certify, 10, jobs=0)

    def test_many(self):
        for ratios in ([10, 20], numpy.array([10, 20]), numpy.array([10.0, 20.0]), iter(("10", "20"))):
            self.assertEqual([c.upper for c in dumbbell.certify_many(ratios, jobs=2)], [4, 5])
        self.assertEqual(dumbbell.certify_many([]), [])


class WhatComesOut(unittest.TestCase):
    def test_a_certificate(self):
        stairs = dumbbell.certify("1:100")
        self.assertEqual((stairs.lower, stairs.upper), (2, 10))
        self.assertEqual(stairs.ratio, (1, 100))
        self.assertEqual(stairs.bytes, (ROOT / "certificates/stairs-1-100.dbc").read_bytes())
        self.assertTrue(all(a[1] == b[0] for a, b in zip(stairs.pieces, stairs.pieces[1:])))
        self.assertTrue(stairs.verify(jobs=2))
        self.assertIn("<svg", stairs.svg())
        self.assertEqual(stairs._repr_svg_(), stairs.svg())
        self.assertEqual(len({stairs, dumbbell.certify((1, 100))}), 1)
        self.assertTrue(dumbbell.certify(10, section="full").verify())

    def test_what_is_open_says_so(self):
        none = dumbbell.certify(10, budget=0)
        self.assertIsNone(none.upper)
        self.assertIn("open", repr(none))
        self.assertTrue(none.verify())
        self.assertIsNone(none._repr_svg_())
        self.assertRaises(TimeoutError, dumbbell.critical, 1000, budget=0)

    def test_the_verifier_is_asked_about_bytes_and_files(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "ten.dbc.gz"
            dumbbell.certify(10).save(file)
            for ten in (TEN, gzip.compress(TEN), file, str(file)):
                self.assertTrue(dumbbell.verify(ten, ratio=10, exactly=4))
            self.assertEqual(dumbbell.verify(Path(folder) / "none", ratio=10).verdict, "unreadable")
        self.assertEqual(dumbbell.verify(TEN.replace(b"upper 4", b"upper 3"), ratio=10, most=3).verdict, "rejected")
        self.assertEqual(dumbbell.verify(TEN, ratio=10, least=5).verdict, "rejected")
        self.assertEqual(dumbbell.verify(TEN, kind="law").verdict, "rejected")
        self.assertRaises(ValueError, dumbbell.verify, TEN)
        self.assertRaises(ValueError, dumbbell.verify, TEN, ratio=10, exactly=4, most=4)

    def test_the_law_agrees_with_what_is_proved(self):
        for q in (1, 2, 10, 63, 1000, 10**6):
            lower, upper = dumbbell.law(q)
            self.assertLessEqual(lower, dumbbell.certify(q).lower)
            self.assertLessEqual(dumbbell.certify(q).upper, upper)
        self.assertGreater(dumbbell.law(Decimal("1e900"))[0], 10**449)

    def test_the_mean_lies_within_the_bounds_of_the_boxes(self):
        incoming = dumbbell.certify_incoming(10, boxes=2000)
        (lo, hi), exact = incoming.mean, dumbbell.mean_collisions(10)
        self.assertTrue(lo < Fraction(exact[0]) <= Fraction(exact[1]) < hi)
        self.assertTrue(incoming.verify())
        self.assertGreaterEqual(sum(share[3] for share in incoming.shares), 1)


def endless():
    """Work that takes much longer than anybody waits."""
    yield "certify", lambda: dumbbell.certify((1, 10**12), gap="1e-9")
    yield "certify_many", lambda: dumbbell.certify_many(range(10**15, 10**15 + 10**6), jobs=2)
    yield "critical", lambda: dumbbell.critical(19999, 1000)
    yield "trace", lambda: dumbbell.trace(10**10, phi="1/2", phidot=10**5, y=3, ydot=-1, digits=50)
    yield "certify_starts", lambda: dumbbell.certify_starts(10, phi=(0, 3), phidot=(-1, 1), y=(2, 3), ydot=(-2, -1), boxes=10**7)


class WhileItWorks(unittest.TestCase):
    def test_ctrl_c_ends_it(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs ignore it
        for name, work in endless():
            with self.subTest(name):
                # From outside: a thread of this process may have to wait for the work.
                killer = subprocess.Popen(["sh", "-c", f"sleep 0.3; kill -INT {os.getpid()}"])
                start = time.process_time()
                with self.assertRaises(KeyboardInterrupt):
                    work()
                    time.sleep(10)  # not before it was done
                    self.fail(f"{name} was over too soon")
                self.assertLess(time.process_time() - start, 10)
                killer.wait()

    def test_other_threads_go_on(self):
        ticks = []
        done = threading.Event()
        other = threading.Thread(target=lambda: [ticks.append(time.monotonic()) for _ in iter(lambda: done.wait(0.001), True)])
        other.start()
        start = time.monotonic()
        dumbbell.certify((1, 30000))
        end = time.monotonic()
        done.set()
        other.join()
        self.assertGreater(sum(start < tick < end for tick in ticks), 3)


class Stubs(unittest.TestCase):
    def test_they_name_what_there_is(self):
        stub = ast.parse((Path(dumbbell.__file__).parent / "__init__.pyi").read_text())
        functions = {node.name: node for node in stub.body if isinstance(node, ast.FunctionDef)}
        classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
        self.assertEqual({*functions, *classes}, set(dumbbell.__all__))
        for name, node in functions.items():
            signature = getattr(dumbbell, name).__doc__.split("\n")[0]
            given = node.args.posonlyargs + node.args.args + node.args.kwonlyargs
            self.assertEqual([arg.arg for arg in given], re.findall(r"[( ](\w+): ", signature), name)
        for name, node in classes.items():
            members = {member.name for member in node.body if isinstance(member, ast.FunctionDef)} - {"__hash__"}
            there = {member for member in vars(getattr(dumbbell, name)) if not member.startswith("_")}
            self.assertEqual({m for m in members if not m.startswith("_")}, there, name)
        self.assertTrue((Path(dumbbell.__file__).parent / "py.typed").exists())


if __name__ == "__main__":
    os.chdir(ROOT)  # the page names files of the project
    unittest.main()
