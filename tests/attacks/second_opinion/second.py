"""Makes the second verifier's modules importable: `import second` goes before them. And what the tests ask of it."""

import hashlib
import os
import random
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[3]
FOLDER = PROJECT / "src/wings/second"
SCALE = int(os.environ.get("DUMBBELL_TEST_SCALE", "1"))  # how much the tests try

sys.dont_write_bytecode = True
sys.path.insert(0, str(FOLDER))

import judge
import options
import program
import source
import values


def demand_of(words):
    """What these words of a command line demand."""
    return options.parse([*words, "FILE"]).jobs[0][1]


def verdict_line(path, words=()):
    """What the program prints with --quiet, without a process of its own, and its exit code."""
    try:
        found = program.examine(str(path), demand_of(words), program.Progress(False))
    except values.Usage as error:
        return str(error), 2
    return f"s {found.word} {found.text}", program.VERDICTS[found.word]


def body(path):
    """The lines of a certificate before its checksum."""
    return source.unpacked(source.read(str(path)))[0].decode().split("\n")[:-2]


def signed(lines):
    text = "".join(line + "\n" for line in lines).encode()
    return text + b"sha256 " + hashlib.sha256(text).hexdigest().encode() + b"\n"


class Sample:
    """A judge that looks at a random part of the conditions only: what it lets pass is not proved."""

    def __init__(self, fraction, seed):
        self._fraction, self._random = fraction, random.Random(seed)
        self.seen = self.checked = 0

    def __call__(self, *condition):
        self.seen += 1
        if self._random.random() < self._fraction:
            self.checked += 1
            judge.judge(*condition)
