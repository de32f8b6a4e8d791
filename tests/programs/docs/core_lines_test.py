"""core_lines_test.py: what an ordinary certificate (section turning, fewer than 20,000 collisions of a ray) rests on lies in
src/verify/core, in as many lines as docs/4-verifying.md says, at most 1,640. Counted is what its check includes, with the
.cpp beside each header. What the core calls of others is named here, with the reason why nothing certified rests on it."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
SRC = ROOT / "src"
MOST = 1640
# What the program calls for such a file, and the rules of its section.
CHECK = ("verify/core/certificate.cpp", "verify/core/turning.cpp")
INCLUDE = re.compile(r'^#include "(.+)"', re.M)

THROWS = "counts work, and can but throw"
OTHER_SECTION = "for files that say so"
LARGE = "L42, for 20,000 collisions of a ray or more"
HEARS = "hears what is compared, for --explain"
# Besides Source, whose bytes are only what is judged.
OUTSIDE = {
    "Budget::take": THROWS,
    "Work::operation": THROWS,
    "Work::collision": THROWS,
    "Work::of_halving": THROWS,
    "Work::of_box": THROWS,
    "share_out": "calls back on threads; a leaf that is left out is a failure",
    "arithmetic_works": "refuses a machine that does not round as IEEE 754 says",
    "guess_root": "a guess, which certified steps start from",
    "guess_top": "a guess, which certified steps start from",
    "Log::box": HEARS,
    "Log::line": HEARS,
    "Log::fact": HEARS,
    "Log::ray": HEARS,
    "Log::there": HEARS,
    "Log::show": HEARS,
    "by_leaps": LARGE,
    "leap": LARGE,
    "full": OTHER_SECTION,
    "plain": OTHER_SECTION,
    "body": OTHER_SECTION,
    "perpendicular": OTHER_SECTION,
    "cells": OTHER_SECTION,
}


def closure():
    found, todo = set(), [SRC / file for file in CHECK]
    while todo:
        file = todo.pop()
        if file in found or not file.exists():
            continue
        found.add(file)
        todo += [SRC / name for name in INCLUDE.findall(file.read_text(encoding="utf-8"))]
        todo.append(file.with_suffix(".cpp"))
    return found


def called(files):
    """The project's functions that these .cpp files call, and none of them has."""
    symbols = {"U": set(), "T": set()}
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            made = pathlib.Path(folder) / (file.stem + ".o")
            subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-I", SRC, "-c", file, "-o", made], check=True)
            names = subprocess.run(["nm", "-C", made], capture_output=True, text=True, check=True).stdout
            for kind, name in re.findall(r"\b([UTWV]) .*?\bdumbbell_verify::([\w:]+)[(<\[]", names):
                symbols["U" if kind == "U" else "T"].add(name)
    return symbols["U"] - symbols["T"]


def main():
    files = closure()
    lines = sum(file.read_text(encoding="utf-8").count("\n") for file in files)
    faults = [f"{file.relative_to(SRC)} is outside of verify/core" for file in files if file.parent != SRC / "verify/core"]
    faults += [f"nothing includes {file.name}" for file in (SRC / "verify/core").iterdir() if file not in files]
    if lines > MOST:
        faults.append(f"more than {MOST:,} lines")
    if f"There are {lines:,} lines in it" not in (ROOT / "docs/4-verifying.md").read_text(encoding="utf-8"):
        faults.append("docs/4-verifying.md gives another number of lines")
    calls = called(file for file in files if file.suffix == ".cpp")
    faults += [f"{name} is called, and not in the core" for name in sorted(calls - set(OUTSIDE))]
    faults += [f"{name} is not called any more" for name in sorted(set(OUTSIDE) - calls)]
    for fault in faults:
        print(fault)
    print(f"{lines:,} lines in {len(files)} files, {len(calls)} calls of others")
    return 1 if faults else 0


sys.exit(main())
