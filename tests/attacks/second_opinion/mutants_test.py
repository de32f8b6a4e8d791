#!/usr/bin/env python3
"""mutants_test.py PROJECT VERIFIER MUTATION NUMBER [OPTION]...: changed certificates, which the driver in tests/attacks/mutation makes
when it is run with these options, and the committed false claims. Of the mutants NUMBER are judged here, in turn of each base, verdict
and reason. What the verifier accepts must be true: recheck.py finds the same claim proved. What the verifier rejects it rejects, too,
in the same line."""

import collections
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True

import recheck
from grammar import Limit, Rejected, Unsupported, unpacked
from judge import Judge


def our_verdict(text):
    """The exit code, the verdict or what is wrong, and the line where."""
    try:
        return 0, recheck.checked(unpacked(text), Judge()), 0
    except Rejected as error:
        return 1, str(error), error.line
    except (Unsupported, Limit) as error:
        return {Unsupported: 3, Limit: 4}[type(error)], str(error), 0


def fields(verdict, left_out=()):
    """The verdict's fields but these, the decided share as a number."""
    pairs = (field.split("=", 1) for field in verdict.split(" "))
    return {key: float(value) if key == "decided" else value for key, value in pairs if key not in left_out}


def rows(table):
    for line in table.read_text().splitlines():
        if not line.startswith("#"):
            yield line.split("\t")


def is_proved_with_more_bits(verifier, options, path):
    """The verifier computes with the bits that a file names, recheck.py with as many as it takes."""
    ended = subprocess.run([verifier, "--quiet", "--precision", "4096", *options.split(), path], capture_output=True, check=False)
    return ended.returncode == 0


def compared(verifier, table):
    """What differs, and how often the two verifiers say the same. Nothing is compared where a file is asked for more than it says,
    where the verifier stops at its limits, and of claims that recheck.py does not know. Lines are not where the last piece does not end
    where it should, which one sees in the piece, the other behind all, and in damaged compressed files, of which one reads what it can."""
    faults, same = [], collections.Counter()
    for name, options, code, line, why_not, claim, why in rows(table):
        if why_not == "claim-not-proved" or code not in ("0", "1", "3"):
            continue
        path = table.parent / name
        found, said, place = our_verdict(path.read_bytes())
        has_place = not said.startswith("the pieces do not tile") and not claim.startswith("the compressed file is")
        if found == 3 and code != "3":
            same["unknown to recheck.py"] += 1
        elif found == 0 and code == "1" and is_proved_with_more_bits(verifier, options, path):
            same["too few bits"] += 1
        elif found != int(code) or (code == "0" and fields(said, ("scene", "sha256")) != fields(claim)):
            faults.append(f"{name} ({why}) {options}: exit code {code}, {claim}; found {found}, {said}")
        elif code == "1" and has_place and place != int(line):
            faults.append(f"{name} ({why}) {options}: line {line}, {claim}; found line {place}, {said}")
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
