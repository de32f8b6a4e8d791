#!/usr/bin/env python3
"""examples_test.py PAGE BIN: runs what a page shows, and compares what comes out with what the page says.

A block that begins with ```console has commands behind `$ `, and below each what it prints. Numbers that differ from
run to run (times, threads) may differ; a line `...` stands for any lines. The commands of a page run in one scratch
folder, one after the other, with the programs of the folder BIN in the PATH; `./run` there is `dumbbell`.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
VARYING = [(r"\d+\.\d+ s\b", "T s"), (r"\d+ threads?", "N threads"), (r' +T s', " T s"), (r'"jobs": \d+', '"jobs": N')]


def examples(text):
    """(command, its expected lines) of all console blocks."""
    found = []
    for block in re.findall(r"^```console\n(.*?)^```$", text, re.M | re.S):
        for line in block.splitlines():
            if line.startswith("$ "):
                found.append((line[2:], []))
            else:
                found[-1][1].append(line)
    return found


def steady(line):
    for pattern, word in VARYING:
        line = re.sub(pattern, word, line)
    return line.rstrip()


def same(expected, actual):
    """Do the lines agree, where `...` stands for any?"""
    if not expected:
        return not actual
    if expected[0] == "...":
        return any(same(expected[1:], actual[i:]) for i in range(len(actual) + 1))
    return bool(actual) and steady(expected[0]) == steady(actual[0]) and same(expected[1:], actual[1:])


def scratch_folder(folder, programs):
    for name in ("certificates", "docs", "proofs"):
        (folder / name).symlink_to(ROOT / name)
    run = folder / "run"
    run.write_text(f'#!/bin/sh\nexec "{programs}/dumbbell" "$@"\n')
    run.chmod(0o755)


def main():
    page, programs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    wanted = examples(page.read_text())
    failures = 0
    with tempfile.TemporaryDirectory() as name:
        scratch_folder(pathlib.Path(name), programs)
        environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}")
        for command, expected in wanted:
            result = subprocess.run(["bash", "-c", command], cwd=name, env=environment, stdin=subprocess.DEVNULL,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            actual = result.stdout.splitlines()
            if not same(expected, actual):
                failures += 1
                print(f"FAILED: {command}\n--- {page.name} says\n" + "\n".join(expected) + "\n--- it prints\n" +
                      "\n".join(actual))
    print(f"{page.name}: {len(wanted)} commands, {failures} failed")
    return 1 if failures or not wanted else 0


if __name__ == "__main__":
    sys.exit(main())
