"""The program: verifies files and prints the verdicts, in the words and with the exit codes of dumbbell-verify."""

import contextlib
import re
import sys
import time
from collections import namedtuple

import certificate
import work
from failure import VERDICTS, Failure, Limit
from grammar import Lines
from judge import judge
from options import DEFAULT_BUDGET, NAME, parse
from source import read, unpacked
from values import Usage

GREATEST_DIGITS = 50_000  # of a number that is printed: Q of a rod with --rod-mass; the format has no more than 2100


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


# The word of the verdict, what follows it, and what is proved, or the Failure.
Result = namedtuple("Result", "word text proof why")


def result(prove, demand, line):
    """The verdict on what prove() returns; line() is the line that was read last."""
    try:
        proof = prove()
        word = "OPEN" if proof.says_nothing(demand) else "VERIFIED"
        return Result(word, f"{proof.text(demand)} {proof.source}{demand.text()}{proof.not_demanded(demand)}", proof, None)
    except Failure as failure:
        why = failure
        why.line = line() if why.line is None else why.line
    except MemoryError:
        why = Limit("out of memory", 0)
    except Exception as error:  # a defect of this program; whatever it is, nothing is proved
        why = Limit(f"a defect of this verifier: {type(error).__name__}", line())
    place = (f"line={why.line} " if why.line else "") + (f"code={why.code} " if why.verdict == "REJECTED" else "")
    return Result(why.verdict, place + one_line(str(why)), None, why)


def examine(path, demand, progress, budget=DEFAULT_BUDGET):
    """The verdict on a file."""
    lines = Lines(b"")

    def prove():
        nonlocal lines
        text, fault = unpacked(read(path))
        lines = Lines(text, fault, progress)
        progress.of = max(1, text.count(b"\n"))
        return certificate.check(lines, demand, judge)

    work.allow(budget)
    return result(prove, demand, lambda: lines.number)


def verify_each(asked, progress):
    """Every file by itself; returns the exit code."""
    found, several = [], len(asked.jobs) > 1
    for path, demand in asked.jobs:
        found.append(examine(path, demand, progress, asked.budget))
        progress.hide()
        if not (several and asked.quiet):
            print(f"s {found[-1].word} {found[-1].text}" + (f" file={one_line(path)}" if several else ""), flush=True)
    words = [one.word for one in found]
    worst = VERDICTS[max(words, key=list(VERDICTS).index)]
    if several:
        totals = " ".join(f"{word.lower()}={words.count(word)}" for word in
                          ("VERIFIED", "REJECTED", "LIMIT", "UNSUPPORTED", "UNREADABLE"))
        print(f"c files={len(found)} {totals} nothing-proved={words.count('OPEN')} "
              f"open={sum(one.proof.open for one in found if one.proof)} exit={worst}", flush=True)
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
            return verify_each(asked, Progress(not asked.quiet))
        print(asked.answer, end="", flush=True)
        return 0
    except Usage as error:
        complain(str(error))
    except OSError:
        complain("cannot write to the standard output")
    return 2
