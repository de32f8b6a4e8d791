#!/usr/bin/env python3
"""shipped_test.py PROJECT: re-checks every certificate of N(q) that the project ships, and compares it with
certificates/claims.tsv. (That of the law for every mass ratio it does not judge.)

Texts over 100,000 bytes by a random 1 % of their leaves and witnesses, the others whole. The seed is the day, so that many
runs see many leaves; it is printed, and recheck.py --sample 0.01 --seed SEED FILE repeats a run."""

import re
import sys
import time
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True

import recheck
from grammar import unpacked
from judge import Judge


def check(path, claim):
    text = unpacked(path.read_bytes())
    judge = Judge(0.01 if len(text) > 100_000 else 1.0, int(time.time()) // 86400)
    start = time.process_time()
    verdict = recheck.checked(text, judge)
    print(f"{path.name}: {judge.checked} of {judge.seen} leaves and witnesses, {time.process_time() - start:.1f} s: {verdict}")
    found = dict(field.split("=") for field in verdict.split(" "))
    asked = dict(zip(claim[::2], claim[1::2]))
    ends = [Fraction(end) for end in asked["--ratio"].split(":")]
    low, high = ends[0], ends[-1]
    expected = f"{low.numerator}/{low.denominator}:{high.numerator}/{high.denominator}"
    most, least = asked.get("--max") or asked["--exactly"], asked.get("--min") or asked["--exactly"]
    return (found["scene"] == asked.get("--scene", "dumbbell") and found["ratio"] == expected
            and int(found["upper"]) <= int(most) and int(found["lower"]) >= int(least) and found["open"] == "0")


def main(project):
    print(f"seed {int(time.time()) // 86400}")
    rows = (line.split("\t") for line in (project / "certificates/claims.tsv").read_text().splitlines() if not line.startswith("#"))
    claims = {f"certificates/{row[0]}": row[1].split(" ") for row in rows}
    shipped = {f"certificates/{path.name}" for path in (project / "certificates").iterdir()
               if re.search(r"\.dbc(\.gz)?$", path.name)}
    if shipped != set(claims) or not shipped:
        return f"certificates/ and certificates/claims.tsv differ: {shipped ^ set(claims)}"
    judged = [name for name in sorted(shipped) if claims[name] != ["--claim", "law"]]
    wrong = [name for name in judged if not check(project / name, claims[name])]
    return f"another claim than that of certificates/claims.tsv: {wrong}" if wrong else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
