#!/usr/bin/env python3
"""demands_test.py: what is demanded of a file, and what of it is not. Weak files that pass a demand fail the next stronger one."""

import itertools
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

import second
from second import body, signed

import certificate
import claim_list
import gaps
import grammar
import program
from values import Usage

CERTIFICATES = second.PROJECT / "certificates"
STAIRS = body(CERTIFICATES / "stairs-1-100.dbc")
STARTS = ["dumbbell-certificate 1", "generator x 1", "lemmas 1", "scene dumbbell", "section none", "claim initial-conditions",
          "ratio 10/1 12/1", "phi 0/1 1/1", "phidot 0/1 0/1", "y 2/1 4/1", "ydot -1/1 -1/1", "bits 53", "between 0 none"]
TREE = ["split phi", "exactly 3 light 1b0 1b1", "split y", "between 2 5", "open",
        "total split 2", "total exactly 1", "total between 1", "total open 1"]


def verdict(lines, claim, judge=lambda *_: None):
    """On these lines, of which nothing else is judged."""
    demand = second.demand_of(claim.split())
    found = program.result(lambda: certificate.check(grammar.Lines(signed(lines)), demand, judge), demand, lambda: 0)
    return f"{found.word} {found.text}"


class Demands(unittest.TestCase):
    def demand(self, lines, claim, expected):
        self.assertRegex(verdict(lines, claim), expected, claim)

    def test_gaps(self):
        """Those that touch are one; what is known at a point does not divide them; they end where the question does."""
        pieces = [(1, 2, 3, 3), (2, 3, 4, 3), (3, 3, 4, 4), (3, 4, 5, 4), (4, 5, 5, 5), (5, 6, None, 0), (6, 7, 6, 6)]
        pieces = [(Fraction(a), Fraction(b), u, v) for a, b, u, v in pieces]
        for low, high, width, known in ((1, 5, "1.00e0", 1), (1, 2, "0", 0), (3, 5, "3.34e-1", Fraction(1, 3)), (1, 7, "1.00e0", None),
                                        (2, Fraction(2003, 1000), "1.50e-3", Fraction(3, 2000)), (5, 5, "", 0), (3, 3, "", 0),
                                        (Fraction(5, 2), Fraction(5, 2), "", None), (6, 6, "", 0)):
            low, high = Fraction(low), Fraction(high)
            self.assertEqual(gaps.widest_text(pieces, low, high), width and f" widest-gap={width}")
            for allowed in (0, Fraction(1, 10**9), Fraction(3, 2000), Fraction(1, 3), 1, 9):
                is_known = gaps.is_known_but_in_gaps(pieces, low, high, allowed, None, 1)
                self.assertEqual(is_known, known is not None and allowed >= known, (low, high, allowed))

    def test_ranges(self):
        weak = [{"upper": "upper 10", "lower": "lower 2"}.get(line.split(" ")[0], line) for line in STAIRS]
        more = [f"upper {int(line[6:]) + 1}" if line.startswith("upper ") else line for line in STAIRS]
        self.demand(weak, "--ratio 1:100 --max 10 --min 2", r"^VERIFIED .* open=17 widest-gap=9.90e1 .* min=2 not-demanded=gap,gaps$")
        self.demand(weak, "--ratio 1:100 --max 10 --gap 0.999", "^REJECTED line=201 code=claim-not-proved ")
        self.demand(weak, "--ratio 50 --gap 0.999", "^REJECTED .* code=claim-not-proved ")
        self.demand(more, "--ratio 1:100 --gap 0.999", "^REJECTED .* code=claim-not-proved ")
        self.demand(STAIRS, "--gap 1e-6", "^VERIFIED .* widest-gap=1.00e-6 .* demanded-gap=1/1000000 not-demanded=ratio,max,min,gaps$")
        self.demand(STAIRS, "--ratio 1:100 --gap 0.99e-6", "^REJECTED .* code=claim-not-proved ")
        self.demand(STAIRS, "--ratio 1:100 --gaps 8 --gap 1e-6", "^VERIFIED .* demanded-gap=1/1000000 demanded-gaps=8 not-demanded=max,min$")
        self.demand(STAIRS, "--ratio 1:100 --gaps 7", "^REJECTED .* code=claim-not-proved ")
        self.demand(weak, "--ratio 1:100 --gaps 1", "^REJECTED .* code=claim-not-proved ")
        self.demand(STAIRS, "--ratio 5:11 --exactly 4", "^VERIFIED .* widest-gap=0 .* exactly=4$")
        self.demand(STAIRS, "--heavy-at-most 1", "^REJECTED .* code=claim-not-proved ")
        self.demand(STAIRS, "", "sha256=[0-9a-f]*$")
        full = body(CERTIFICATES / "full-100.dbc.gz")
        self.demand(full, "--ratio 100 --exactly 10", "^VERIFIED .* not-demanded=heavy-at-most$")
        self.demand(full, "--ratio 100 --exactly 10 --heavy-at-most 1", "^VERIFIED .* exactly=10 demanded-heavy-at-most=1$")

    def test_bodies(self):
        coin, rod = body(CERTIFICATES / "coin.dbc"), body(CERTIFICATES / "rod-10.dbc.gz")
        for claim in ("--coin --exactly 4", "--rho 1 --inertia 4 --exactly 4", "--scene body --inertia 4 --rho 1 --exactly 4"):
            self.demand(coin, claim, "^VERIFIED .* demanded-inertia=4/1:4/1 demanded-rho=1/1:1/1 exactly=4 demanded-scene=body$")
        self.demand(coin, "--rho 1", "^VERIFIED .* not-demanded=inertia,max,min$")
        self.demand(coin, "--inertia 1/4 --rho 1 --exactly 4", "^REJECTED .* nothing is said of Q in 1/4:1/4, only of 4/1:4/1$")
        self.demand(rod, "--ratio 1/10 --rod-mass 1/100 --exactly 5", "^VERIFIED .* demanded-inertia=12132363/1248521:12132363/1248521 "
                                                                     "demanded-rho=211/2011:211/2011 exactly=5 demanded-scene=body$")
        self.demand(rod, "--ratio 10 --rod-mass 0.0101 --exactly 5", "^REJECTED .* code=claim-not-proved ")

    def test_starts(self):
        """Bounds and share are those of the part of the box that is asked about; a point on a border is in the upper leaf."""
        for sides, least, most, share in (("", 0, None, "1/2"), ("--phi 0:1/2", 3, 3, "1"), ("--phi 1/4:3/4", 0, None, "1/2"),
                                          ("--phi 1/2", 0, None, "0"), ("--phi 0:3/4 --y 2:3", 2, 5, "2/3"), ("--phi 1 --y 2", 2, 5, "0"),
                                          ("--phi 3/4:1 --y 3", 0, None, "0"), ("--phi 1/8 --ydot -1", 3, 3, "1")):
            claim = f"--claim initial-conditions --ratio 11 {sides}"
            self.demand(STARTS + TREE, f"{claim} --decided {share}", "^OPEN " if (share, most) == ("0", None) else "^VERIFIED ")
            self.demand(STARTS + TREE, f"{claim} --decided {Fraction(share) + Fraction(1, 10**30)}" if share != "1" else f"{claim} --min 4",
                        "^REJECTED .*code=claim-not-proved ")
            self.demand(STARTS + TREE, f"{claim} --min {least}", "^VERIFIED ")
            self.demand(STARTS + TREE, f"{claim} --min {least + 1}", "^REJECTED .*code=claim-not-proved ")
            self.demand(STARTS + TREE, f"{claim} --max {99 if most is None else most - 1}", "^REJECTED .*code=claim-not-proved ")
            if most is not None:
                self.demand(STARTS + TREE, f"{claim} --max {most}", "^VERIFIED .*not-demanded=.*,min,decided$")
        for beyond in ("--phi -1/9:1", "--y 5", "--phidot 0:1", "--ydot -1:0", "--ratio 9:10"):
            self.demand(STARTS + TREE, f"--claim initial-conditions {beyond}", "^REJECTED .*nothing is said of all ")

    def test_usage(self):
        """What does not fit together is refused, in whatever order it stands."""
        start, law = "--claim initial-conditions", "--claim law"
        for claim in ("--coin --ratio 4", "--rho 1 --ratio 4", "--inertia 4 --ratio 4", "--scene body --ratio 4", "--coin --rho 1",
                      "--rod-mass 1 --rho 1 --ratio 3", "--rod-mass 1", "--rod-mass 1 --ratio 2:3", "--scene dumbbell --coin", "--rho 1 --max 3",
                      "--inertia 3 --gap 0", "--scene body --max 3", "--rho 1:2", "--gap 1", "--gap -1/9", "--gap x", "--heavy-at-most 2",
                      "--phi 1", f"{law} --decided 1", f"{start} --gap 0", f"{start} --ratio 1/2", f"{start} --decided 1.1", f"{start} --coin",
                      f"{start} --scene body --ratio 2", "--claim incoming --phi 1", f"{law} --ratio 2", f"{law} --coin", "--exactly 2 --min 2",
                      "--claim adiabatic-run --exponent 0", "--claim adiabatic-scattering --heights 1", "--claim adiabatic-run --constant 1,2",
                      "--claim adiabatic-bounce --max 3", "--coin=1", "--delta 1/9", "--phi 1:0 --claim initial-conditions"):
            words = [" --".join(("", *order)).split() for order in itertools.permutations(claim[2:].split(" --"))]
            for spelled in words:
                self.assertRaises(Usage, second.demand_of, spelled)
        second.demand_of("--constant 1,2 --attained 1/3 --exponent 1/2 --heights 0:1 --delta 1/9 --margin 1 --claim adiabatic-bounce".split())

    def test_lists(self):
        """Rows that demand too little, or where no demand is read, are refused; the others have each its verdict."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "claims.tsv"
            rows = lambda *texts: path.write_text("".join(f"{text}\n" for text in texts)) and claim_list.read_claims(str(path))
            for row in ("a", "a\t", "\t--ratio 3 --max 3", "a\t--ratio 3", "a\t--ratio 3 --gap 0", "a\t--max 3", "a\t--rho 1 --inertia 4", "# a",
                        "a\t--claim incoming --max 3", "a\t--claim incoming --ratio 2", "a\t--claim adiabatic-run --delta 1/9", "a\t--scene body",
                        "a\t--ratio 3 --max 3\t--min 2", "a\t--ratio 3 --max 3\tx\t  --min 2", "a\t--ratio 3 --max 3 b", "a\t--max 3 --quiet",
                        "a\t--ratio 3 --max 3\r", "\ufeffa\t--ratio 3 --max 3", "a\t--ratio 3 --ratio 3 --max 3"):
                self.assertRaisesRegex(Usage, rf"^{path}(:1)?: ", rows, row)
            found = rows("# remark", "", "a.dbc\t--ratio=3 --max 3\tdumbbell certify --max 4", "/b\t--claim law", "-\t--coin --min 4",
                         "c\t--claim incoming --decided 1 --ratio 2", "d\t--claim adiabatic-run --delta 1/9 --constant 3")
            self.assertEqual([name for name, _ in found], [f"{folder}/a.dbc", "/b", "-", f"{folder}/c", f"{folder}/d"])
            self.assertEqual(found[0][1], second.demand_of("--max 3 --ratio 3".split()))


if __name__ == "__main__":
    unittest.main()
