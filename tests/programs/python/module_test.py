#!/usr/bin/env python3
"""The installed module dumbbell: what it takes and gives, its docstrings and its chapter, Ctrl-C, threads, stubs."""
import ast
import copy
import doctest
import gzip
import json
import math
import multiprocessing
import os
import pickle
import re
import signal
import subprocess
import sys
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
BIN = Path(sys.prefix).parent / "bin"
TEN = (ROOT / "certificates/q-10.dbc").read_bytes()


def examples_of(page):
    """What a page shows of Python."""
    text = re.sub(r"^```.*$", "", page.read_text(), flags=re.M)
    return doctest.DocTestParser().get_doctest(text, {}, page.name, str(page), 0)


START = {"phi": "1/3", "phidot": 2, "y": 2, "ydot": -1}
KINDS = [None, True, numpy.array(True), object(), b"10", bytearray(b"10"), [10], (1, 2, 3), {}, -math.inf, Decimal("inf"), Decimal("sNaN"),
         Decimal("1e999999"), numpy.float32("nan"), numpy.longdouble("1e4000"), 10**5000, -10**5000, 10**400, 2**64, -1, 0, "ten", "", "\ud800", "1\0",
         "1:2:3", Fraction(-1, 3), numpy.array([1, 2]), numpy.array(math.nan), numpy.timedelta64(3, "s"), int, {3}, "9" * 6000]


def calls():
    """Each argument of each function and method, but the names of files."""
    ten, options = dumbbell.certify(10), {"section": "turning", "gap": "1e-6", "jobs": 1, "budget": 1}
    for name, given in {"certify": {"q": 10, **options}, "critical": {"n": 4, "digits": 5, "budget": 1}, "law": {"q": 10}, "mean_collisions": {"q": 10},
                        "certify_many": {"ratios": [10], **options}, "trace": {"q": 10, **START, "digits": 0},
                        "certify_starts": {"q": 10, **START, "boxes": 5, "digits": 0, "jobs": 1, "budget": 1},
                        "certify_incoming": {"q": 10, "boxes": 5, "jobs": 1, "budget": 1},
                        "verify": {"certificate": ten.bytes, "ratio": 10, "most": 4, "least": 4, "kind": "collisions", "jobs": 1, "budget": 1},
                        "Certificate": {"file": ten.bytes, "jobs": 1}}.items():
        for argument in given:
            yield f"{name}: {argument}", lambda what: getattr(dumbbell, name)(**{**given, argument: what})
    for name, body in (("rho", {"inertia": 4}), ("inertia", {"rho": 1}), ("rod_mass", {"q": 10}), ("coin", {})):
        yield f"certify: {name}", lambda what: dumbbell.certify(**body, budget=0, **{name: what})
    yield "verify: exactly", lambda what: dumbbell.verify(TEN, exactly=what)
    yield "one of many", lambda what: dumbbell.certify_many([10, what])
    yield "an end of a range", lambda what: dumbbell.certify((1, what))
    yield "jobs of a certificate", lambda what: ten.verify(jobs=what)


def load_tests(loader, tests, pattern):
    for suite in (doctest.DocTestSuite(_dumbbell), doctest.DocTestSuite(dumbbell),
                  unittest.TestSuite([doctest.DocTestCase(examples_of(ROOT / "docs/13-python.md"))])):
        assert suite.countTestCases() > 0
        tests.addTests(suite)
    return tests


class WhatGoesIn(unittest.TestCase):
    def test_all_that_is_exactly_ten_is_ten(self):
        for ten in (10, 10.0, "10", "1e1", Fraction(10), Decimal(10), (10, 10), numpy.int64(10), numpy.float32(10), numpy.array(10), numpy.array(10.0)):
            self.assertEqual(dumbbell.certify(ten).bytes, TEN)

    def test_a_float_is_its_exact_value(self):
        self.assertEqual(dumbbell.certify(4.6).ratio[0], Fraction(4.6))
        self.assertEqual(dumbbell.certify("4.6").ratio[0], Fraction(46, 10))
        self.assertEqual(dumbbell.certify(math.ulp(1.0)).ratio[0], 2**52)

    def test_what_is_no_number_is_refused(self):
        for what in (True, [10], 1j, b"10", (1, 2, 3)):
            self.assertRaises(TypeError, dumbbell.certify, what)
        for what in ("ten", "", 0, -1, "2:1", (1, float("nan"))):
            self.assertRaises(ValueError, dumbbell.certify, what)

    def test_what_cannot_be_taken_is_an_input_error_wherever_it_is_given(self):
        """All arguments with all kinds of things: a few can be taken here and there, which the next test tells apart."""
        for name, call in calls():
            for what in KINDS:
                with self.subTest(name, what=type(what)):
                    try:
                        call(what)
                    except (dumbbell.InputError, TimeoutError) as error:
                        str(error)

    def test_what_is_no_number_is_taken_by_no_argument(self):
        for name, call in calls():
            for what in (math.inf, math.nan, Decimal("nan"), numpy.bool_(True), object(), 1j):
                with self.subTest(name, what=what):
                    self.assertRaises(dumbbell.InputError, call, what)

    def test_exact_numbers_that_come_out_go_in_at_their_greatest_length(self):
        for digits in (300, 1000):
            for bound, n in zip(dumbbell.critical(4, digits), (3, 4)):
                proof = dumbbell.certify(bound)
                self.assertEqual(dumbbell.certify(proof.ratio), proof)
                self.assertTrue(proof.verify() and dumbbell.verify(proof.bytes, ratio=proof.ratio, least=proof.lower))
                self.assertIn(n, dumbbell.law(proof.ratio[0]))
                self.assertTrue(digits > 300 or proof.lower == proof.upper == n)
        self.assertEqual(dumbbell.law(10**400), dumbbell.law("1e400"))
        self.assertRaises(dumbbell.InputError, dumbbell.certify, "1." + "7" * 1500)  # no line of a certificate holds it

    def test_a_mistake_is_said_in_a_sentence_of_the_program(self):
        with self.assertRaisesRegex(dumbbell.InputError, "the range '2:1' is reversed: write the smaller ratio first"):
            dumbbell.certify("2:1")
        with self.assertRaisesRegex(ValueError, "there is no critical ratio for N = 2"):
            dumbbell.critical(2)
        with self.assertRaisesRegex(ValueError, "are too many"):
            dumbbell.critical(10**40)
        for call in (lambda: dumbbell.certify(10, gap=1), lambda: dumbbell.verify(TEN, kind="lore"), lambda: dumbbell.verify(TEN, least=-1),
                     lambda: dumbbell.certify(10, section="half"), lambda: dumbbell.certify(10, jobs=0), lambda: dumbbell.verify(TEN, ratio=""),
                     lambda: dumbbell.certify_many("12"), lambda: dumbbell.certify_many(b"12"), lambda: dumbbell.certify(10, budget=-1),
                     lambda: dumbbell.critical(10**40)):
            with self.assertRaises(dumbbell.InputError) as caught:
                call()
            self.assertNotIn("--", str(caught.exception))

    def test_many(self):
        for ratios in ([10, 20], numpy.array([10, 20]), numpy.array([10.0, 20.0]), iter(("10", "20"))):
            self.assertEqual([c.upper for c in dumbbell.certify_many(ratios, jobs=2)], [4, 5])
        self.assertEqual(dumbbell.certify_many([]), [])


class Questions(unittest.TestCase):
    def test_the_module_answers_as_the_programs_do(self):
        rows = [row.split("\t") for row in (ROOT / "tests/rooms/wings/api/questions.tsv").read_text().splitlines() if not row.startswith("#")]
        self.assertGreater(len(rows), 40)
        for question, answer in rows:
            with self.subTest(question):
                self.assertEqual(of_programs(*question.split()), answer)
                self.assertEqual(of_module(*question.split()), answer)


def of_programs(function, *words):
    with tempfile.TemporaryDirectory() as folder:
        if function == "verify":
            words = [BIN / "dumbbell-verify", "--json", *words[1:], ROOT / "certificates" / words[0]]
        else:
            words = [BIN / "dumbbell", function, *(["--ratio"] if function == "law" else []), *words, "--json"]
            words += ["--out", f"{folder}/it.dbc"] if function == "certify" else []
        said = subprocess.run(words, capture_output=True, text=True).stdout
    if not said:
        return "refused"
    of = json.loads(said)
    return {"certify": lambda: of["sha256"][:16], "verify": lambda: of[0]["verdict"].lower(), "critical": lambda: of["ratios"][0]["q_c"],
            "law": lambda: f"{of['lower']} {of['upper']}", "trace": lambda: f"{of['least']} {of['most']}"}[function]()


def of_module(function, *words):
    """Its options are keywords, its subject the first argument."""
    given, subject, name = {}, [], None
    for word in words:
        if word.startswith("--"):
            name = word[2:].replace("-", "_")
            given[name] = True
        elif name:
            given[name] = word
        else:
            subject = [ROOT / "certificates" / word if function == "verify" else int(word) if function == "critical" else word]
    if "digits" in given:
        given["digits"] = int(given["digits"])
    try:
        found = getattr(dumbbell, function)(*subject, **given)
    except dumbbell.InputError:
        return "refused"
    return {"certify": lambda: found.sha256[:16], "verify": lambda: found.verdict, "critical": lambda: str(found[0])[:given["digits"] + 1],
            "law": lambda: f"{found[0]} {found[1]}", "trace": lambda: f"{found.lower} {found.upper}"}[function]()


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

    def test_bodies(self):
        coin, ten = dumbbell.certify(coin=True), dumbbell.certify(10)
        self.assertEqual((coin.scene, coin.ratio, coin.rho, ten.scene, ten.rho), ("body", (4, 4), 1, "dumbbell", None))
        self.assertEqual(dumbbell.certify(10, rod_mass=Fraction(1, 100), section="plain"), dumbbell.Certificate(ROOT / "certificates/rod-10.dbc.gz"))
        self.assertTrue(coin.verify())
        self.assertIsNone(coin._repr_svg_())
        for wrong in ({}, {"q": 10, "coin": True}, {"rho": 1}, {"rod_mass": 1}):
            self.assertRaises(dumbbell.InputError, dumbbell.certify, **wrong)

    def test_what_is_open_says_so(self):
        none = dumbbell.certify(10, budget=0)
        self.assertIsNone(none.upper)
        self.assertEqual((none.demand, none.verify().verdict), ("--ratio 10", "open"))
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
        for claim in ({}, {"most": 4}, {"exactly": 4}, {"ratio": None, "least": 4}, {"kind": "collisions", "budget": None}):
            self.assertTrue(dumbbell.verify(TEN, **claim))
        law = ROOT / "certificates/law.dbc.gz"
        self.assertTrue(dumbbell.verify(law) and not dumbbell.verify(law, most=10**6) and not dumbbell.verify(law, kind="collisions"))
        self.assertRaises(ValueError, dumbbell.verify, TEN, ratio=10, exactly=4, most=4)

    def test_what_can_be_demanded_has_its_name(self):
        coin = ROOT / "certificates/coin.dbc"
        self.assertTrue(dumbbell.verify(coin, scene="body", coin=False, least=None))
        self.assertEqual(dumbbell.verify(coin, rho=(Fraction(1, 2), 1), inertia=4, most=4).verdict, "rejected")
        for wrong in ("gapp", "gap", "max"):
            with self.assertRaisesRegex(dumbbell.InputError, wrong):
                dumbbell.verify(TEN, most=4, **{wrong: "1e-6 --exactly=4"})
        with self.assertRaisesRegex(dumbbell.InputError, "`file=4` states no claim"):
            dumbbell.verify(TEN, file=4)

    def test_a_file_is_a_certificate_again_if_it_is_verified(self):
        stairs = ROOT / "certificates/stairs-1-100.dbc"
        self.assertEqual(dumbbell.Certificate(stairs), dumbbell.certify("1:100"))
        self.assertEqual(dumbbell.Certificate(gzip.compress(TEN)).pieces, dumbbell.certify(10).pieces)
        self.assertIsNone(dumbbell.Certificate(dumbbell.certify(10, budget=0).bytes).upper)
        body = ROOT / "certificates/law.dbc.gz"
        for wrong in (TEN.replace(b"upper 4", b"upper 3"), body, ROOT / "none", b""):
            self.assertRaises(dumbbell.InputError, dumbbell.Certificate, wrong)

    def test_names_of_files_are_those_of_open(self):
        script = r"""if True:
            import os, dumbbell
            ten = dumbbell.certify(10)
            for name in (os.fsdecode(b"\xff\xc3.dbc"), "-", b"bytes"):
                ten.save(name)
                with open(name, "rb") as file:
                    assert file.read() == ten.bytes
                assert dumbbell.verify(os.fsdecode(name), exactly=4) and dumbbell.Certificate(os.fsdecode(name)) == ten
            names = set(os.listdir())
            for name in ("bytes\0", "-\0x", "", "no/folder\udcff/x", "\ud800"):
                for call in (ten.save, dumbbell.Certificate):
                    try:
                        call(name)
                    except dumbbell.InputError:
                        continue
                    raise AssertionError(name)
            assert set(os.listdir()) == names"""
        for locale in ({"LC_ALL": "C.UTF-8"}, {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}):
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([sys.executable, "-c", script], cwd=folder, env={**os.environ, **locale}, check=True, stdin=subprocess.DEVNULL)

    def test_what_is_returned_is_compared_copied_and_crosses_processes(self):
        ten, box = dumbbell.certify(10), dumbbell.certify_starts(10, phi=(0, 1), phidot=0, y=2, ydot=-1, boxes=50)
        self.assertTrue(ten in [None, 1, dumbbell.certify("10")] and ten != None and not ten == "x")  # noqa: E711
        orbit = dumbbell.trace(10, phi="1/3", phidot=2, y=2, ydot=-1)
        for thing in (ten, box, ten.verify(), dumbbell.verify(TEN, exactly=3), orbit, orbit.collisions[0], dumbbell.certify, dumbbell.law):
            for again in (copy.copy(thing), copy.deepcopy(thing), pickle.loads(pickle.dumps(thing))):
                for name in (name for name in dir(thing) if not name.startswith("_") and not callable(getattr(thing, name))):
                    self.assertEqual(repr(getattr(again, name)).split(" object at")[0], repr(getattr(thing, name)).split(" object at")[0])
        for what in (None, "2:1"):
            with self.assertRaises(dumbbell.InputError) as caught:
                dumbbell.certify(what)
            again = pickle.loads(pickle.dumps(caught.exception))
            self.assertEqual((type(again), str(again)), (type(caught.exception), str(caught.exception)))
        for method in ("fork", "spawn"):
            with multiprocessing.get_context(method).Pool(1) as pool:
                self.assertEqual(pool.map(dumbbell.certify, [10]), [ten])

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

    def test_the_interpreter_ends_while_threads_work(self):
        for name, call in (("certify", "certify((1, 10**12), gap='1e-9', jobs=2)"), ("critical", "critical(19999, 1000)"), ("verify", "certify(10).verify()")):
            code = f"""if True:
                import threading, time, dumbbell
                def work():
                    while True:
                        dumbbell.{call}
                for _ in range(3):
                    threading.Thread(target=work, daemon=True).start()
                time.sleep(0.1)"""
            for _ in range(3):
                ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
                self.assertEqual((ended.returncode, ended.stderr), (0, ""), name)

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
            members = {getattr(member, "name", None) or member.target.id for member in node.body if not isinstance(member, ast.Expr)}
            there = {member for member in vars(getattr(dumbbell, name)) if not member.startswith("_")}
            self.assertEqual({m for m in members if not m.startswith("_")}, there, name)
        self.assertTrue((Path(dumbbell.__file__).parent / "py.typed").exists())


if __name__ == "__main__":
    os.chdir(ROOT)  # the page names files of the project
    unittest.main()
