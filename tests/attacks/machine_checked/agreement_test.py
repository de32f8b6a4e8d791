#!/usr/bin/env python3
"""agreement_test.py PROJECT PROVE DUMBBELL DUMBBELL_VERIFY MUTATION: the checker extracted from the Coq proof and the project's verifier
have the same verdict on what both can judge, files with the sections turning and full of the scene dumbbell: on the shipped certificates, the
committed false claims, a sample of all mutants, and on certificates written now. Where the verifier says no, the proved checker must.

DUMBBELL_PROVE_SCALE (1) times as many fresh certificates, and mutants (up to ten times), and the largest shipped certificate. Exit code 77 if PROVE was not built: `./run prove` does."""

import gzip
import hashlib
import os
import random
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

sys.dont_write_bytecode = True
PROJECT = Path(sys.argv[1])
PROVE, DUMBBELL, VERIFIER, MUTATION = sys.argv[2:6]
del sys.argv[1:6]
SCALE = int(os.environ.get("DUMBBELL_PROVE_SCALE", "1"))
BASES = ["equal", "single", "thousand", "single-split", "deep", "range", "range-from-1", "range-split", "range-deep", "open", "loose", "big",
         "big-range", "full", "full-equal", "full-range", "full-deep", "full-again"]
JUDGED = [[b"lemmas " + lemmas, b"scene dumbbell", b"section " + section]
          for lemmas, section in ((b"1", b"turning"), (b"1", b"full"), (b"minimal", b"full"))]


def verdict(program, options, path):
    ended = subprocess.run([program, *options, path], capture_output=True, text=True, check=False)
    return ended.returncode, (ended.stdout.splitlines() or [ended.stderr])[-1]


def is_judged(path):
    data = path.read_bytes()
    try:
        data = gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
    except (OSError, EOFError, zlib.error):
        return True  # refused by both
    lines = data.split(b"\n")
    return lines[2:5] in JUDGED and lines[5:6] != [b"claim law"]


def manifest(path):
    for line in path.read_text().splitlines():
        if line and not line.startswith("#"):
            name, options, code = line.split("\t")[:3]
            yield path.parent / name, options.split(), int(code)


def tampered(lines, chance):
    """A certificate with one line of a tree, a bound or the ratios changed, and its checksum again right."""
    changes = {"count": lambda a: f"count {max(0, int(a) + chance.choice([-1, -1, -1, 1]))}",
               "split": lambda a: f"split {chance.choice([axis for axis in ('e', 't', 'eta', 'q') if axis != a])}",
               "upper": lambda a: f"upper {int(a) - 1}", "lower": lambda a: f"lower {int(a) + 1}"}
    places = [k for k, line in enumerate(lines) if line.split()[0] in changes]
    common = [k for k in places if lines[k].split()[0] in ("count", "split")]
    place = chance.choice(common if chance.random() < 0.9 else places)
    word, *rest = lines[place].split()
    text = "".join(line + "\n" for line in [*lines[:place], changes[word](*rest), *lines[place + 1:-1]])
    return f"{text}sha256 {hashlib.sha256(text.encode()).hexdigest()}\n"


class Agreement(unittest.TestCase):
    def same(self, options, path, theirs=None):
        theirs = verdict(VERIFIER, ["--quiet", *options], path) if theirs is None else theirs
        ours = verdict(PROVE, options, path)
        if theirs[0] == 0:
            self.assertEqual(ours[0], 0, f"{path} {options}: {ours[1]}, but the verifier accepts it")
        else:
            self.assertNotEqual(ours[0], 0, f"{path} {options}: {ours[1]}, but the verifier has exit code {theirs[0]}")
        return ours

    def test_shipped(self):
        tried = 0
        for row in (PROJECT / "certificates/claims.tsv").read_text().splitlines():
            name, claim, _, small = row.split("\t")
            path = PROJECT / name
            if name.startswith("#") or not is_judged(path) or (small != "yes" and SCALE == 1):
                continue
            theirs = verdict(VERIFIER, ["--quiet", *claim.split()], path)
            ours = self.same(claim.split(), path, theirs)
            self.assertEqual(ours[1], theirs[1])
            tried += 1
        self.assertGreater(tried, 5)

    def refused(self, table):
        """How many files of the table were refused and accepted."""
        numbers = [0, 0]
        for path, options, code in manifest(table):
            if is_judged(path) and not any(option.startswith(("--scene", "--claim")) for option in options):
                self.same(options, path, (code, ""))
                numbers[code == 0] += 1
        return numbers

    def test_false_claims(self):
        refused, _ = self.refused(PROJECT / "tests/attacks/false_claims/manifest.tsv")
        self.assertGreater(refused, 40)

    def test_mutants(self):
        total = 0
        for base in BASES:
            with tempfile.TemporaryDirectory() as folder:
                corpus = Path(folder) / "corpus"
                subprocess.run([MUTATION, "--jobs", "1", "--base", base, "--most", str(400 * min(SCALE, 10)), "--dump", corpus, str(40 * min(SCALE, 10))],
                               check=True, capture_output=True)
                refused, accepted = self.refused(corpus / "manifest.tsv")
                print(f"{base}: {refused} refused, {accepted} accepted by both")
                total += refused
        self.assertGreater(total, 200)

    def test_plain_mutants(self):
        """The mutants above have no certificate with `lemmas minimal`."""
        chance = random.Random(16)
        lines = gzip.decompress((PROJECT / "certificates/full-plain-10.dbc.gz").read_bytes()).decode().splitlines()
        refused = 0
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "tampered.dbc"
            for _ in range(60 * SCALE):
                path.write_text(tampered(lines, chance))
                refused += self.same([], path)[0] != 0
        self.assertGreater(refused, 40)

    def test_fresh(self):
        chance = random.Random(4)
        for _ in range(20 * SCALE):
            low = round(10 ** chance.uniform(0, 4), chance.randrange(6))
            # Single ratios, narrow ranges, and ratios next to a step, which take more than 53 bits.
            request = chance.choice([[str(low)], [f"{low}:{low * (1 + 10 ** chance.uniform(-6, -1)):.9f}"], ["4.603338848751701"],
                                     [f"{4.603338848751 + chance.uniform(0, 1e-11):.17f}"],
                                     [f"{1 + chance.uniform(0, 100):.3f}", "--section", "full"],
                                     [f"{1 + chance.uniform(0, 6):.3f}", "--section", "full", "--lemmas", "none"]])
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / "fresh.dbc"
                written = subprocess.run([DUMBBELL, "certify", *request, "--out", path], capture_output=True, text=True, check=False)
                self.assertIn(written.returncode, (0, 3), written.stderr)
                if path.exists():
                    theirs = verdict(VERIFIER, ["--quiet"], path)
                    ours = self.same([], path, theirs)
                    self.assertEqual(ours[1], theirs[1], request)


if __name__ == "__main__":
    if not os.access(PROVE, os.X_OK):
        print(f"{PROVE} is not there: ./run prove builds it")
        sys.exit(77)
    unittest.main()
