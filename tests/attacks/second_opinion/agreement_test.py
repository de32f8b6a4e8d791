#!/usr/bin/env python3
"""agreement_test.py DUMBBELL DUMBBELL_VERIFY: on what the program writes today the second verifier prints what the first one
does. Two programs that have nothing but the proofs and the format in common."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import second

DUMBBELL, VERIFIER = sys.argv[1:3]
del sys.argv[1:3]

WRITTEN = [
    "certify 7", "certify 5/2:6", "certify 1:2", "certify 4.603338848751701", "certify 4.6:4.61 --gap 1e-40", "certify 1e6",
    "certify 3 --section full", "certify 2:3 --section full", "certify 3/2 --section plain",
    "certify --coin", "certify --rho 9/10 --inertia 2",
    "certify --rho 9/10 --inertia 21/10:22/10 --section plain", "certify --rho 7/25 --inertia 20:60",
    "trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2 --subdivide",
    "trace 10:11 --phi 0:1 --phidot -1/2:1/2 --y 3/2 --ydot -1:-1/2 --subdivide --max-boxes 60",
    "trace 100 --phi -2:1 --phidot 1:2 --y 3/2 --ydot -1:1 --subdivide --max-boxes 300",
    "trace 1000 --phi 7 --phidot -1/100 --y 6/5 --ydot -1/50:-1/60 --subdivide --max-boxes 100",
    "trace 1 --phi 0:6 --phidot -1:1 --y 3/2:2 --ydot 1/5:1 --subdivide --max-boxes 100",
    "trace 1 --incoming --subdivide --max-boxes 200", "trace 10 --incoming --subdivide --max-boxes 400",
    "trace 4.61 --incoming --subdivide --max-boxes 60", "trace 1000 --incoming --subdivide --max-boxes 300",
]
if second.SCALE > 1:
    WRITTEN += ["certify 1e9", "certify 2 --section plain", "certify --rho 1/2 --inertia 3",
                "trace 1000 --incoming --subdivide --max-boxes 1000"]


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
                first = subprocess.run([VERIFIER, "--quiet", file], capture_output=True, text=True, check=False)
                line, code = second.verdict_line(file)
                self.assertEqual((line + "\n", code), (first.stdout, 0))


if __name__ == "__main__":
    unittest.main()
