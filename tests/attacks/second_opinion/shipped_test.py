#!/usr/bin/env python3
"""shipped_test.py VERIFIER: on every certificate that the project ships, with the claim of certificates/claims.tsv, the second
verifier prints what the first one does; but for the law, which it does not judge.

Of texts over 100,000 bytes a random 1/200 of the leaves and witnesses is judged, the others are judged whole. The seed is the
day, so that many runs see many leaves."""

import subprocess
import sys
import time
import unittest

import second

import certificate
import grammar
import program
import source

VERIFIER = sys.argv.pop()
CERTIFICATES = second.PROJECT / "certificates"
SEED = int(time.time()) // 86400


def claims():
    """The files of the list, and the options that state their claims."""
    lines = (CERTIFICATES / "claims.tsv").read_text().splitlines()
    rows = [line.split("\t") for line in lines if not line.startswith("#")]
    return {row[0]: row[1].split(" ") for row in rows}


class Shipped(unittest.TestCase):
    def test_verdicts(self):
        for name, claim in claims().items():
            with self.subTest(name=name):
                path, start = CERTIFICATES / name, time.process_time()
                if claim == ["--claim", "law"]:
                    line, code = second.verdict_line(path, claim)
                    self.assertEqual((line.split(" ")[1], code), ("UNSUPPORTED", 3))
                    continue
                first = subprocess.run([VERIFIER, "--quiet", *claim, path], capture_output=True, text=True, check=False)
                text = source.unpacked(source.read(str(path)))[0]
                if len(text) > 100_000:
                    sample, demand = second.Sample(min(1, 0.005 * second.SCALE), SEED), second.demand_of(claim)
                    found = program.result(lambda: certificate.check(grammar.Lines(text), demand, sample), demand, lambda: 0)
                    print(f"{name}: {sample.checked} of {sample.seen} leaves and witnesses, seed {SEED}")
                    self.assertEqual((f"s {found.word} {found.text}\n", 0), (first.stdout, first.returncode))
                else:
                    line, code = second.verdict_line(path, claim)
                    self.assertEqual((line + "\n", code), (first.stdout, first.returncode))
                print(f"{name}: {time.process_time() - start:.1f} s")


if __name__ == "__main__":
    unittest.main()
