#!/usr/bin/env python3
"""examples_test.py PAGE BIN [--update]: runs what a page shows, and compares what comes out with what the page says.

A block that begins with ```console has commands after `$ `, and below each what it prints. Numbers that differ from
run to run (times, threads) may differ; a line `...` stands for any lines. The commands of a page run in one scratch
folder, one after the other, with the programs of the folder BIN in the PATH; `./run` there is `dumbbell`. With --update
what is different is written into the page.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
VARYING = [(r"\d+\.\d+ s\b", "T s"), (r" +T s", " T s"), (r"\d+ threads?", "N threads"), (r'"jobs": \d+', '"jobs": N')]


def parts(text):
    """The page in order: (None, lines) as they stand, and (command, the lines that it is said to print)."""
    result, inside = [(None, [])], False
    for line in text.splitlines():
        if line.startswith("```"):
            inside = line == "```console"
            result.append((None, [line]))
        elif inside and line.startswith("$ "):
            result.append((line[2:], []))
        else:
            result[-1][1].append(line)
    return result


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


def printed(command, folder, programs):
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}")
    result = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return result.stdout.splitlines()


def main():
    page, programs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    commands, differ, lines = 0, 0, []
    with tempfile.TemporaryDirectory() as folder:
        scratch_folder(pathlib.Path(folder), programs)
        for command, expected in parts(page.read_text()):
            if command is None:
                lines += expected
                continue
            commands += 1
            actual = printed(command, folder, programs)
            agree = same(expected, actual)
            lines += [f"$ {command}"] + (expected if agree else actual)
            if not agree:
                differ += 1
                print(f"{command}\n--- {page.name} says\n" + "\n".join(expected) + "\n--- it prints\n" + "\n".join(actual))
    print(f"{page.name}: {commands} commands, {differ} print something else")
    if "--update" in sys.argv:
        page.write_text("\n".join(lines) + "\n")
        return 0
    return 1 if differ or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
