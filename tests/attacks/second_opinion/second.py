"""Makes the second verifier's modules importable: `import second` goes before them. And what the tests ask of it."""

import random
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[3]
FOLDER = PROJECT / "src/second"

sys.dont_write_bytecode = True
sys.path.insert(0, str(FOLDER))

import judge
import options
import program


def verdict_line(path, words=()):
    """What the program prints with --quiet, without a process of its own, and its exit code."""
    word, text = program.verdict(str(path), options.parse([*words, "FILE"]).demand, program.Progress(False))
    return f"s {word} {text}", program.VERDICTS[word]


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
