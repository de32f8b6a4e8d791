#!/usr/bin/env python3
"""tampered_test.py PROJECT: changed certificates, their totals and checksums made right again, are refused for the right reason;
and what else recheck.py answers, with its exit codes."""

import gzip
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True

from resealed import body, recounted, signed

PROJECT = Path(sys.argv.pop())
HERE = Path(__file__).parent

INCOMING = "../tests/attacks/fuzz/bases/incoming.dbc"
LAST = "between 1 4\nbetween 1 4\ntotal split 95"  # the last leaf reaches s = 1

TREE = "split lambda\ncount 3 2\ncount 2 3\ncount 2 3\ncount 1 3\noutside\noutside\ncount 1 1\nlower 6"

# file, lines (they occur once, as a whole), what they become, line and reason
TAMPERED = [
    # One collision less is claimed.
    ("q-10.dbc", "upper 4", "upper 3", 13, "the leaf counts more than `upper`"),
    ("q-10.dbc", "upper 4\nchart bridge\ncount 1 2\nchart light\ncount 1 1\nlower 4",
     "upper 3\nchart bridge\ncount 1 1\nchart light\ncount 1 1\nlower 3", 13, "the leaf `count` is not certified"),
    ("q-10.dbc", "upper 4\nchart bridge\ncount 1 2\nchart light\ncount 1 1\nlower 4",
     "upper 3\nchart bridge\ncount 0 2\nchart light\ncount 1 1\nlower 3", 13, "the leaf `count` is not certified"),
    ("q-100.dbc", "upper 10\nchart bridge\ncount 4 5\nchart light\ncount 4 4\nlower 10",
     "upper 9\nchart bridge\ncount 4 4\nchart light\ncount 4 4\nlower 9", 13, "the leaf `count` is not certified"),
    ("q-1.dbc", "upper 2\nequal-masses\nlower 2", "upper 1\nequal-masses\nlower 1", 12, "equal-masses needs"),
    # One collision more is claimed.
    ("q-10.dbc", "upper 4", "upper 5", None, None),  # true, and weaker
    ("q-10.dbc", "lower 4", "lower 5", 16, "the lower bound is above the upper one"),
    ("q-10.dbc", "upper 4\nchart bridge\ncount 1 2\nchart light\ncount 1 1\nlower 4",
     "upper 5\nchart bridge\ncount 1 2\nchart light\ncount 1 1\nlower 5", 17, "the witness has less than `lower`"),
    ("q-10.dbc", "upper 4\nchart bridge\ncount 1 2\nchart light\ncount 1 1\nlower 4\nwitness bridge 1b-1 1b-1 1 2",
     "upper 5\nchart bridge\ncount 1 2\nchart light\ncount 1 1\nlower 5\nwitness bridge 1b-1 1b-1 2 2", 17,
     "the witness is not certified"),
    # Another box: another ratio, halves exchanged, another axis, a split undone.
    ("q-10.dbc", "ratio 10/1 10/1\npieces 1\npiece 10/1 10/1", "ratio 12/1 12/1\npieces 1\npiece 12/1 12/1", 13,
     "the leaf `count` is not certified"),
    ("q-10.dbc", "piece 10/1 10/1", "piece 9/1 10/1", 9, "the pieces do not tile"),
    ("q-10.dbc", "piece 10/1 10/1", "piece 10/1 11/1", 9, "the pieces do not tile"),
    ("stairs-1-100.dbc", TREE, TREE.replace("count 2 3\ncount 1 3", "count 1 3\ncount 2 3"), 100,
     "the leaf `count` is not certified"),
    ("stairs-1-100.dbc", TREE, TREE.replace("split lambda\ncount 3 2", "split e\ncount 3 2"), 98,
     "the leaf `count` is not certified"),
    ("stairs-1-100.dbc", TREE, TREE.replace("split lambda\ncount 3 2", "split eta\ncount 3 2"), 97, "not an axis"),
    ("stairs-1-100.dbc", TREE, TREE.replace("split lambda\ncount 3 2\ncount 2 3", "count 2 3"), 97,
     "the leaf `count` is not certified"),
    ("wedge-1-100.dbc", "split lambda\ncount 2 1\ncount 1 2\nlower 3", "count 1 2\nlower 3", 34,
     "the leaf `count` is not certified"),
    ("wedge-1-100.dbc", "upper 5\nchart wedge\ncount 2 2\nlower 4\nwitness wedge 0b0 1b-1 2 1",
     "upper 4\nchart wedge\ncount 2 1\nlower 4\nwitness wedge 0b0 1b-1 2 1", 56, "the leaf `count` is not certified"),
    # Another reason for a leaf, or one that the chart does not have.
    ("q-10.dbc", "count 1 1", "meets", 15, "the leaf `meets` is not certified"),
    ("q-10.dbc", "count 1 1", "meets-reversed", 15, "the leaf `meets-reversed` is not certified"),
    ("q-10.dbc", "count 1 1", "outside", 15, "the leaf `outside` is not certified"),
    ("q-10.dbc", "count 1 2", "outside", 13, "the leaf `outside` is not certified"),
    ("q-10.dbc", "count 1 2", "meets", 13, "no node of the chart bridge"),
    ("q-10.dbc", "count 1 2", "once", 13, "no node of the chart bridge"),
    ("q-10.dbc", "count 1 2", "count 3", 13, "too few or too many fields"),
    # A leaf or a chart is missing, or one too many.
    ("stairs-1-100.dbc", TREE, TREE.replace("count 1 1\nlower 6", "lower 6"), 104, "no node of the chart light: lower"),
    ("q-10.dbc", "count 1 1", "count 1 1\ncount 1 1", 16, "expected `lower`"),
    ("q-10.dbc", "chart light\ncount 1 1\n", "", 14, "expected `chart light`"),
    ("q-10.dbc", "chart bridge\ncount 1 2\nchart light\ncount 1 1", "equal-masses", 12, "equal-masses needs"),
    # Another witness.
    ("q-10.dbc", "witness bridge 1b-1 1b-1 1 2", "witness bridge 3b-1 1b-1 1 2", 17, "the witness is not certified"),
    ("q-10.dbc", "witness bridge 1b-1 1b-1 1 2", "witness bridge 1b-1 0b0 1 2", 17, "the witness is not certified"),
    ("q-10.dbc", "witness bridge 1b-1 1b-1 1 2", "witness bridge 1b-1 19b-1 1 2", 17, "the witness is not certified"),
    ("q-10.dbc", "witness bridge 1b-1 1b-1 1 2", "witness bridge 1b-1 1b-1 2 1", 17, "the witness is not certified"),
    ("q-10.dbc", "witness bridge 1b-1 1b-1 1 2", "witness bridge 2b-1 1b-1 1 2", 17, "not of the classes"),
    ("hybrid-1-100.dbc", "witness wedge 0b0 1b-21 2 1", "witness wedge 0b0 1b-21 1 2", 51, "the witness is not certified"),
    # All incoming trajectories: other counts, another first contact, another ratio.
    (INCOMING, "exactly 1 light 5b-9 33b-9", "between 1 4 light 5b-9 33b-9", None, None),  # true, and weaker
    (INCOMING, "exactly 1 light 5b-9 33b-9", "exactly 2 light 5b-9 33b-9", 103, "the leaf `exactly` is not certified"),
    (INCOMING, "exactly 1 light 5b-9 33b-9", "exactly 1 heavy 5b-9 33b-9", 103, "the leaf `exactly` is not certified"),
    (INCOMING, "exactly 1 light 5b-9 33b-9", "exactly 1 light 5b-9 17b-9", 103, "the leaf `exactly` is not certified"),
    (INCOMING, "exactly 1 light 5b-9 33b-9", "exactly 1", 103, "a leaf without its window"),
    (INCOMING, "between 1 2 light 3b-8 5b-6", "exactly 1 light 3b-8 5b-6", 102, "the leaf `exactly` is not certified"),
    (INCOMING, "between 1 4 light 9b-7 27b-7", "between 1 3 light 9b-7 27b-7", 98, "the leaf `between` is not certified"),
    (INCOMING, "ratio 10/1 10/1", "ratio 10/1 11/1", 7, "LO = HI is required"),
    (INCOMING, "ratio 10/1 10/1", "ratio 100/1 100/1", 17, "the leaf `between` is not certified"),
    # What is left up to s = 1, where the states have no bound.
    (INCOMING, LAST, LAST.replace("4\ntotal", "9\ntotal"), 9, "the leaves say between 1 9"),
    (INCOMING, LAST, LAST.replace("4\ntotal", "3\ntotal"), 200, "the leaf `between` is not certified"),
    (INCOMING, LAST, LAST.replace("1 4\ntotal", "2 4\ntotal"), 200, "the leaf `between` is not certified"),
    (INCOMING, LAST, LAST.replace("1 4\ntotal", "1 4 light 3b-8 5b-6\ntotal"), 200, "the leaf `between` is not certified"),
    (INCOMING, LAST, LAST.replace("between 1 4\ntotal", "exactly 0\ntotal"), 200, "the leaf `exactly` is not certified"),
    (INCOMING, LAST, LAST.replace("between 1 4\ntotal", "open\ntotal"), 9, "the leaves say between 0 none"),
    # Another section, or a box.
    (INCOMING, "split s", "split phidot", 10, "not an axis"),
    (INCOMING, "split s", "split q", 10, "not an axis"),
    (INCOMING, "split phi\nexactly 1 heavy 465b-9 247b-8", "split s\nexactly 1 heavy 465b-9 247b-8", 20,
     "the leaf `exactly` is not certified"),
    (INCOMING, "bits 53", "phi 0/1 6/1\nbits 53", 8, "expected `bits`"),
    (INCOMING, "claim incoming", "claim initial-conditions", 8, "expected `phi`"),
]


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

    def test_each_change(self):
        for name, old, new, line, reason in TAMPERED:
            with self.subTest(file=name, old=old, new=new):
                text = "\n".join(["", *body(PROJECT / "certificates" / name), ""])
                self.assertTrue(f"\n{old.strip()}\n" in text)
                parts = text.split(old if old.endswith("\n") else f"\n{old}\n", 1)
                text = parts[0] + (new if old.endswith("\n") else f"\n{new}\n") + parts[1]
                changed = signed(recounted(text[1:-1].split("\n")))
                if line is None:
                    self.expect(changed, 0, "VERIFIED ")
                else:
                    self.expect(changed, 1, f"REJECTED at line {line}: {reason}")

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

    def test_files_and_usage(self):
        self.assertEqual(self.run_file(str(HERE)), (2, "UNREADABLE: Is a directory\n"))
        self.assertEqual(self.run_file(str(HERE / "none")), (2, "UNREADABLE: No such file or directory\n"))
        self.assertEqual(self.run_file()[0], 2)
        self.assertEqual(self.run_file("--sample", "0", str(HERE))[0], 2)


if __name__ == "__main__":
    unittest.main()
