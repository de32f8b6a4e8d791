#!/usr/bin/env python3
"""agreement_test.py DUMBBELL DUMBBELL_VERIFY: the verdict on what the program writes today, and on random changes of it, is the
one that the project's verifier gives. Two programs that have nothing but the proofs and the format in common."""

import random
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True

import recheck
from grammar import Limit, Rejected, Unsupported
from judge import Judge
from resealed import body, recounted, signed

DUMBBELL, VERIFIER = sys.argv[1:3]
del sys.argv[1:3]

WRITTEN = [
    "certify 7", "certify 5/2:6", "certify 1:2", "certify 4.603338848751701", "certify 4.6:4.61 --gap 1e-40", "certify 1e9",
    "certify 3 --section full", "certify 2:3 --section full", "certify 2 --section plain",
    "certify 1:9 --scene wedge", "certify 1:9 --scene hybrid",
    "trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2 --subdivide",
    "trace 10:11 --phi 0:1 --phidot -1/2:1/2 --y 3/2 --ydot -1:-1/2 --subdivide --max-boxes 60",
    "trace 100 --phi -2:1 --phidot 1:2 --y 3/2 --ydot -1:1 --subdivide --max-boxes 300",
    "trace 1000 --phi 7 --phidot -1/100 --y 6/5 --ydot -1/50:-1/60 --subdivide --max-boxes 100",
    "trace 1 --phi 0:6 --phidot -1:1 --y 3/2:2 --ydot 1/5:1 --subdivide --max-boxes 100",
    "trace 1 --incoming --subdivide --max-boxes 200", "trace 10 --incoming --subdivide --max-boxes 400",
    "trace 4.61 --incoming --subdivide --max-boxes 60", "trace 1000 --incoming --subdivide --max-boxes 1000",
]
STRANGE = ["0", "1", "-1", "00", "1000000000000000000", "1/1", "0/1", "2/2", "1b-400", "1b9999", "0b0", "2b0", "none", "q", "e", "eta",
           "lambda", "t", "phi", "s", "ydot", "meets", "meets-reversed", "outside", "once", "open", "count", "exactly", "between", "light",
           "heavy", "split", "upper", "lower", ""]
MUTANTS = 300


def our_verdict(text):
    """The exit code and the verdict's fields."""
    try:
        return 0, recheck.checked(text, Judge())
    except (Rejected, Unsupported, Limit) as error:
        return {Rejected: 1, Unsupported: 3, Limit: 4}[type(error)], str(error)


def their_verdict(text, folder):
    scene = re.search(rb"^scene (wedge|hybrid)$", text, re.MULTILINE)
    file = Path(folder) / "file.dbc"
    file.write_bytes(text)
    ended = subprocess.run([VERIFIER, *(["--scene", scene[1].decode()] if scene else []), file], capture_output=True, text=True,
                           check=False)
    return ended.returncode, ended.stdout.splitlines()[-1]


def fields(verdict):
    """The verdict's fields, the decided share as a number."""
    pairs = dict(field.split("=", 1) for field in verdict.split(" "))
    return pairs | ({"decided": float(pairs["decided"])} if "decided" in pairs else {})


def changed(lines, chance):
    """The lines with one small change."""
    lines, k = list(lines), chance.randrange(len(lines))
    fields = lines[k].split(" ")
    j = chance.randrange(len(fields))
    kind = chance.randrange(7)
    number = re.fullmatch(r"(-?\d+)(?:([/b])(-?\d+))?", fields[j])
    if kind < 3 and number:
        over, sign, under = int(number[1]), number[2], number[3]
        step = chance.choice((-2, -1, 1, 2))
        fields[j] = f"{over + step}{sign or ''}{under or ''}" if not sign or chance.random() < 0.5 else f"{over}{sign}{int(under) + step}"
    elif kind < 4:
        fields[j] = chance.choice(STRANGE)
    elif kind < 5:
        return lines[:k] + lines[k + 1:]
    elif kind < 6:
        return lines[:k] + [chance.choice(lines)] + lines[k:]
    else:
        other = chance.randrange(len(lines))
        lines[k], lines[other] = lines[other], lines[k]
        return lines
    lines[k] = " ".join(fields)
    return lines


class Agreement(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.files = []
        for number, command in enumerate(WRITTEN):
            file = Path(cls.folder.name) / f"{number}.dbc"
            ended = subprocess.run([DUMBBELL, *command.split(" "), "--out", file], capture_output=True, text=True, check=False)
            if ended.returncode not in (0, 3):
                raise AssertionError(f"{command}: {ended.stderr}")
            cls.files.append((command, file))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_what_the_program_writes(self):
        for command, file in self.files:
            with self.subTest(command=command):
                ours, theirs = our_verdict(file.read_bytes()), their_verdict(file.read_bytes(), self.folder.name)
                self.assertEqual(ours[0], 0, ours[1])
                self.assertEqual(theirs[0], 0, theirs[1])
                self.assertEqual(fields(theirs[1].removeprefix("s VERIFIED ")), fields(ours[1]))

    def test_small_changes(self):
        chance, verdicts = random.Random(11), {}
        small = [body(file) for command, file in self.files if file.stat().st_size < 20_000 and "1e" not in command]
        for _ in range(MUTANTS):
            lines = changed(chance.choice(small), chance)
            text = signed(recounted(lines) if chance.random() < 0.7 else lines)
            ours, theirs = our_verdict(text), their_verdict(text, self.folder.name)
            verdicts[ours[0]] = verdicts.get(ours[0], 0) + 1
            self.assertEqual(ours[0], theirs[0], f"{ours} {theirs}\n{text.decode()[:3000]}")
        print(f"verdicts on {MUTANTS} changed files: {verdicts}")
        self.assertGreater(verdicts[1], MUTANTS // 2)
        self.assertGreater(verdicts[0], 0)


if __name__ == "__main__":
    unittest.main()
