"""The program: verifies files and prints the verdicts, in the words and with the exit codes of dumbbell-verify."""

import contextlib
import re
import sys
import time

import certificate
import work
from failure import VERDICTS, Failure
from grammar import Lines
from judge import judge
from options import DEFAULT_BUDGET, NAME, Usage, parse
from source import read, unpacked

GREATEST_DIGITS = 4300  # of a number that is read or printed; the format's have no more than 2100


def one_line(text):
    """Without what a terminal obeys."""
    return re.sub("[\x00-\x1f\x7f-\x9f]", "?", text)


def say(text):
    """On the standard error, if there is one."""
    with contextlib.suppress(OSError, AttributeError):
        sys.stderr.write(text)
        sys.stderr.flush()


def complain(text):
    say(f"{NAME}: {one_line(text)}\n")


class Progress:
    """A line on a terminal that says how much of a text was read; after a second, and then five times in a second."""

    def __init__(self, wanted):
        self.wanted = wanted and sys.stderr is not None and sys.stderr.isatty()
        self.of, self.due, self.shown = 1, time.monotonic() + 1, False

    def __call__(self, number):
        if self.wanted and time.monotonic() >= self.due:
            self.due, self.shown = time.monotonic() + 0.2, True
            say(f"\rverifying: {100 * (number - 1) // self.of:3d} % of the lines")

    def hide(self):
        if self.shown:
            say("\r" + " " * 40 + "\r")
            self.shown = False


def verdict(path, demand, progress, budget=DEFAULT_BUDGET):
    """The verdict on a file: its word, and what follows it."""
    lines = Lines(b"")
    work.allow(budget)
    try:
        text, fault = unpacked(read(path))
        lines = Lines(text, fault, progress)
        progress.of = max(1, text.count(b"\n"))
        proof = certificate.check(lines, demand, judge)
        word = "OPEN" if proof.says_nothing(demand) else "VERIFIED"
        return word, f"{proof.text} sha256={proof.checksum}{demand.text()}"
    except Failure as why:
        line = lines.number if why.line is None else why.line
        place = (f"line={line} " if line else "") + (f"code={why.code} " if why.verdict == "REJECTED" else "")
        return why.verdict, place + one_line(str(why))
    except MemoryError:
        return "LIMIT", "out of memory"
    except Exception as error:  # a defect of this program; whatever it is, nothing is proved
        return "LIMIT", f"line={lines.number} a defect of this verifier: {type(error).__name__}"


def run(asked):
    """Verifies all files; returns the exit code."""
    found, progress, several = [], Progress(not asked.quiet), len(asked.files) > 1
    for path in asked.files:
        word, text = verdict(path, asked.demand, progress, asked.budget)
        found.append(word)
        progress.hide()
        if not (several and asked.quiet):
            print(f"s {word} {text}" + (f" file={one_line(path)}" if several else ""), flush=True)
    worst = VERDICTS[max(found, key=list(VERDICTS).index)]
    if several:
        totals = " ".join(f"{word.lower()}={found.count(word)}" for word in
                          ("VERIFIED", "REJECTED", "LIMIT", "UNSUPPORTED", "UNREADABLE", "OPEN"))
        print(f"c files={len(found)} {totals} exit={worst}", flush=True)
    return worst


def main(words):
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(GREATEST_DIGITS)
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.reconfigure(errors="replace")  # names of files may be no text
    try:
        asked = parse(words)
        if sys.stdout is None:
            raise OSError
        if asked.answer is None:
            return run(asked)
        print(asked.answer, end="", flush=True)
        return 0
    except Usage as error:
        complain(str(error))
    except OSError:
        complain("cannot write to the standard output")
    return 2
