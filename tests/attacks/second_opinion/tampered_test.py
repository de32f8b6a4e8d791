#!/usr/bin/env python3
"""tampered_test.py PROJECT: what recheck.py answers, with its exit codes. (Changed certificates: mutants_test.py.)"""

import gzip
import hashlib
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True

from grammar import unpacked

PROJECT = Path(sys.argv.pop())
HERE = Path(__file__).parent


def body(path):
    """The lines of a certificate before its checksum."""
    return unpacked(path.read_bytes()).decode().split("\n")[:-2]


def signed(lines):
    text = "".join(line + "\n" for line in lines).encode()
    return text + b"sha256 " + hashlib.sha256(text).hexdigest().encode() + b"\n"


class Tampered(unittest.TestCase):
    def run_on(self, text, *options):
        """Exit code and output of recheck.py for a file with these bytes."""
        with tempfile.NamedTemporaryFile() as file:
            file.write(text)
            file.flush()
            return self.run_file(file.name, *options)

    def run_file(self, *arguments):
        ended = subprocess.run([sys.executable, HERE / "recheck.py", *arguments], capture_output=True, text=True, check=False)
        return ended.returncode, ended.stdout

    def expect(self, text, code, output):
        ended = self.run_on(text)
        self.assertEqual(ended[0], code, ended[1])
        self.assertIn(output, ended[1])
        self.assertEqual(code == 0, ended[1].startswith("VERIFIED"))

    def test_every_count_of_a_cover_of_all_states(self):
        """With one collision less in all leaves, some leaf does not hold."""
        for name in ("full-100.dbc.gz", "full-plain-10.dbc.gz"):
            lines = body(PROJECT / "certificates" / name)
            less = [f"count {max(0, int(line[6:]) - 1)}" if line.startswith("count ") else line for line in lines]
            self.expect(signed(less), 1, "the leaf `count` is not certified")
            self.expect(signed(["split eta" if line == "split e" else line for line in lines]), 1, "is not certified")
            self.expect(signed(["split q" if line == "split e" else line for line in lines]), 1, "the box is a point in this axis")

    def test_totals_checksum_and_end(self):
        lines = body(PROJECT / "certificates/q-10.dbc")
        self.expect(signed([line.replace("total count 2", "total count 3") for line in lines]), 1,
                    "REJECTED at line 19: the total of count is 2")
        whole = signed(lines)
        self.expect(whole.replace(b"upper 4", b"upper 5"), 1, "REJECTED at line 26: the checksum is another")
        self.expect(whole + b"\n", 1, "REJECTED at line 27: something follows")
        self.expect(whole[:-1], 1, "REJECTED at line 26: the text ends too early, or without a line feed")
        self.expect(whole.replace(b"\n", b"\r\n"), 1, "REJECTED at line 1: a byte that is not allowed")
        self.expect(b"", 1, "REJECTED at line 1: the text ends too early")
        packed = gzip.compress(whole)
        self.expect(packed, 0, "VERIFIED ")
        self.expect(packed + packed, 1, "REJECTED at line 0: not exactly one gzip member")
        self.expect(packed[:-9], 1, "REJECTED at line 0: not exactly one gzip member")

    def test_unsupported(self):
        lines = body(PROJECT / "certificates/q-10.dbc")
        for old, new in (("dumbbell-certificate 1", "dumbbell-certificate 2"), ("lemmas 1", "lemmas 2"),
                         ("lemmas 1", "lemmas minimal"), ("scene dumbbell", "scene moon"), ("section turning", "section none"),
                         ("claim collisions", "claim heavy"), ("claim collisions", "claim initial-conditions"),
                         ("claim collisions", "claim incoming")):
            self.expect(signed([line.replace(old, new) for line in lines]), 3, "UNSUPPORTED: ")

    def test_a_sample_is_no_proof(self):
        code, output = self.run_file("--sample", "0.5", "--seed", "3", str(PROJECT / "certificates/stairs-1-100.dbc"))
        self.assertEqual(code, 5)
        self.assertRegex(output, r"^SAMPLED [1-9]\d* of 66 leaves and witnesses, seed 3: no fault found; scene=dumbbell ")

    def test_an_open_file_proves_nothing(self):
        """It is right all the same."""
        lines = [line for line in body(PROJECT / "certificates/q-10.dbc")]
        first, last = lines.index("upper 4"), lines.index("total split 0")
        totals = ["total " + word + " 0" for word in "split count outside meets meets-reversed equal-masses witness".split()]
        ended = self.run_on(signed([*lines[:first], "upper none", "lower 0", *totals, "total open 1"]))
        self.assertEqual(ended[0], 3, ended[1])
        self.assertTrue(ended[1].startswith("OPEN scene=dumbbell "))

    def test_files_and_usage(self):
        self.assertEqual(self.run_file(str(HERE)), (2, "UNREADABLE: Is a directory\n"))
        self.assertEqual(self.run_file(str(HERE / "none")), (2, "UNREADABLE: No such file or directory\n"))
        self.assertEqual(self.run_file()[0], 2)
        self.assertEqual(self.run_file("--sample", "0", str(HERE))[0], 2)


if __name__ == "__main__":
    unittest.main()
