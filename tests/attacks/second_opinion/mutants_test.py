#!/usr/bin/env python3
"""mutants_test.py PROJECT VERIFIER MUTATION NUMBER [OPTION]...: changed certificates, which the driver in tests/attacks/mutation makes
when it is run with these options, and the committed false claims. Of the mutants NUMBER are judged here, in turn of each base, verdict
and reason. What the verifier accepts must be true: the second one finds the same claim proved. What the verifier rejects it rejects,
too, in the same line and with the same code."""

import collections
import subprocess
import sys
import tempfile
from pathlib import Path

import second


def rows(table):
    for line in table.read_text().splitlines():
        if not line.startswith("#"):
            yield line.split("\t")


def is_proved_with_more_bits(verifier, options, path):
    """The verifier computes with the bits that a file names, the second one with as many as it takes."""
    ended = subprocess.run([verifier, "--quiet", "--precision", "4096", *options.split(), path], capture_output=True, check=False)
    return ended.returncode == 0


def compared(verifier, table):
    """What differs, and how often the two verifiers say the same. Nothing is compared where the first one stops at its limits,
    and of claims that the second one does not know. Lines are not where the last piece does not end where it should, which one sees
    in the piece, the other behind all, and in damaged compressed files, of which one reads what it can."""
    faults, same = [], collections.Counter()
    for name, options, code, place, why_not, claim, why in rows(table):
        if code == "4":
            continue
        path = table.parent / name
        line, found = second.verdict_line(path, options.split())
        expected = f" {claim} sha256=" if code == "0" else f" line={place} code={why_not} " if code == "1" else ""
        if code == "1" and ("the last piece does not end" in line or why_not == "gzip"):
            expected = ""
        if found == 3 and code != "3":
            same["unknown to the second one"] += 1
        elif found == 0 and code == "1" and is_proved_with_more_bits(verifier, options, path):
            same["too few bits"] += 1
        elif found != int(code) or expected not in line:
            faults.append(f"{name} ({why}) {options}: exit code {code}, line {place}, {why_not}, {claim}; found {line}")
        else:
            same[f"exit code {code}"] += 1
    return faults, same


def main(project, verifier, mutation, number, *options):
    with tempfile.TemporaryDirectory() as folder:
        mutants = Path(folder) / "mutants"
        made = subprocess.run([mutation, *options, "--dump", mutants, number], check=False).returncode
        faults = ["the driver found a defect"] if made else []
        for table in (mutants / "manifest.tsv", Path(project) / "tests/attacks/false_claims/manifest.tsv"):
            wrong, same = compared(verifier, table)
            print(f"{table.parent.name}: the same verdict {dict(same)}, another {len(wrong)}")
            faults += wrong
    return "\n".join(faults) if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
