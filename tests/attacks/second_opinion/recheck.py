#!/usr/bin/env python3
"""A second opinion: re-checks certificates, written from the proofs and the format alone. It shares nothing with the C++ programs.

    recheck.py FILE                          VERIFIED ... (exit code 0) or REJECTED at line L: reason (1)
    recheck.py --sample 0.01 --seed 7 FILE   the whole structure, but only a random part of the leaves and witnesses:
                                             SAMPLED ... (5), which proves nothing, or REJECTED (1)

Other ends: UNREADABLE or wrong usage (2), UNSUPPORTED (3), LIMIT (4), OPEN (3): right, but nothing is proved by it.
"""

import argparse
import sys

sys.dont_write_bytecode = True  # leaves no folder behind in the source tree

import collisions
import incoming
import initial
from grammar import Limit, Lines, Rejected, Unsupported, unpacked
from judge import Judge

WORDS = {
    "lemmas": {"1", "minimal"},
    "scene": {"dumbbell", "wedge", "hybrid"},
    "section": {"turning", "full", "none"},
    "claim": {"collisions", "initial-conditions", "incoming"},
}


def checked(text, judge):
    """The verdict's fields for the text of a file."""
    lines = Lines(text)
    version, = lines.line("dumbbell-certificate", "nat")
    if version != 1:
        raise Unsupported(f"format version {version}")
    lines.line("generator", "word", "version")
    known = {}
    for key, words in WORDS.items():
        known[key], = lines.line(key, "lemmas" if key == "lemmas" else "word")
        if known[key] not in words:
            raise Unsupported(f"{key} {known[key]}")
    header = known["lemmas"], known["scene"], known["section"]
    if known["claim"] == "collisions" and header in collisions.SECTIONS:
        return collisions.check(lines, header, judge)
    if known["claim"] != "collisions" and header == initial.HEADER:
        return (incoming if known["claim"] == "incoming" else initial).check(lines, judge)
    raise Unsupported("this combination of lemmas, scene, section and claim")


def proves(verdict):
    """Whether there is a bound for all that the file is about, or a number for a part of it."""
    return "upper=none lower=0 " not in verdict and "collisions=0:none decided=0.000000000000 " not in verdict


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=float, default=1.0, metavar="FRACTION", help="of the leaves and witnesses")
    parser.add_argument("--seed", type=int, default=0, help="of the sample")
    parser.add_argument("file")
    options = parser.parse_args()
    if not 0 < options.sample <= 1:
        parser.error("--sample: above 0, at most 1")
    judge = Judge(options.sample, options.seed)
    try:
        with open(options.file, "rb") as file:
            verdict = checked(unpacked(file.read()), judge)
    except OSError as error:
        print(f"UNREADABLE: {error.strerror}")
        return 2
    except Rejected as error:
        print(f"REJECTED at line {error.line}: {error}")
        return 1
    except Unsupported as error:
        print(f"UNSUPPORTED: {error}")
        return 3
    except (Limit, MemoryError) as error:
        print(f"LIMIT: {error}")
        return 4
    if options.sample < 1:
        print(f"SAMPLED {judge.checked} of {judge.seen} leaves and witnesses, seed {options.seed}: no fault found; {verdict}")
        return 5
    print(f"{'VERIFIED' if proves(verdict) else 'OPEN'} {verdict}")
    return 0 if proves(verdict) else 3


if __name__ == "__main__":
    sys.exit(main())
