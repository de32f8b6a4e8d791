"""The command line: the claim, in the words of dumbbell-verify, and the files."""

import re
from fractions import Fraction

from demand import Demand

NAME = "dumbbell-verify.pyz"
VERSION = "0.1.0"
DEFAULT_BUDGET = 600  # seconds
SCENES = "dumbbell", "hybrid", "wedge", "body"
CLAIMS = ("collisions", "initial-conditions", "incoming", "adiabatic-bounce", "adiabatic-run", "adiabatic-scattering",
          "law")

HELP = f"""usage: {NAME} [options] FILE...
Checks certificates of the program dumbbell (docs/reference/format.md): every line, in interval arithmetic on whole
numbers. It shares no code with dumbbell-verify, the first verifier, and needs nothing but Python 3.8 or later.

  --ratio RATIO|LO:HI   the mass ratios (heavy/light) in question; default: those of the file
  --rho RATIO|LO:HI     with --scene body: d2/d1 of the bodies in question, above 0 and at most 1. --ratio is then their
                        Q = (d1/k)^2
  --max N               demand the proof that no trajectory has more than N collisions
  --min N               demand the proof that some trajectory has at least N collisions
  --exactly N           both
  --scene dumbbell|hybrid|wedge|body
                        demand this scene; default: dumbbell if another option states the claim, else the file's
  --claim KIND          demand this kind of claim: collisions, initial-conditions or incoming
  --budget TIME         give up on a file that costs more work than a core does in about this time: 30s, 10m, 2h
                        (10m). Counted in steps, not by a clock
  --quiet               print the last line only, and show no progress
  -h, --help            print this help and end
  -V, --version         print the version and end

  {NAME} --ratio 10 --exactly 4 ten.dbc           is N*(10) = 4 proved?
  {NAME} --ratio 1:100 --max 10 stairs.dbc.gz     at most 10 collisions on the whole range?
  {NAME} ten.dbc                                  what does this file prove?
  {NAME} --claim incoming --max 4 incoming.dbc    at most 4 from every incoming trajectory?
  {NAME} --ratio 3 --max 3 *.dbc                  which files prove this?

FILE `-` is the standard input; files may be packed with gzip. For one file the last line is the verdict: s VERIFIED,
s OPEN, s REJECTED, s UNSUPPORTED, s UNREADABLE or s LIMIT. Each of several files has one such line with its name, and
a line of totals ends them. Exit codes: 0 verified and proved; 1 rejected; 2 usage or unreadable; 3 unsupported, or
open (no claim is stated, and no bound is proved for all that is in question); 4 resource limit. If files differ: the
first of 1, 4, 3, 2, 0.

It does not judge the law for every mass ratio, nor the adiabatic invariant: such files are unsupported. It is
much slower than dumbbell-verify: minutes for a range up to 10^6.
"""


class Usage(Exception):
    """What is wrong with the command line."""


class Asked:
    """The files, and what is asked of them. `answer`: print this text and nothing else."""

    def __init__(self):
        self.files, self.demand, self.quiet, self.answer = [], Demand(), False, None
        self.budget = DEFAULT_BUDGET


def decimal(text):
    """What a decimal such as 10, 2.5, 1e6 or 10^6 stands for; None of other texts."""
    power = re.fullmatch(r"10\^([+-]?[0-9]+)", text)
    match = re.fullmatch(r"([0-9]+)(?:\.([0-9]+))?(?:[eE]([+-]?[0-9]+))?", text)
    if not (power or match):
        return None
    exponent = power[1] if power else match[3] or "0"
    if len(exponent.lstrip("+-0")) > 4 or abs(int(exponent)) > 1000:
        raise Usage(f"an exponent beyond 1000: {text[:60]}")
    digits, places = ("1", "") if power else (match[1], match[2] or "")
    return int(digits + places) * Fraction(10) ** (int(exponent) - len(places))


def mass_ratio(text):
    """RATIO, exactly."""
    ratio = None
    if len(text) <= 1000:
        fraction = re.fullmatch(r"([0-9]+)/([0-9]*[1-9][0-9]*)", text)
        ratio = Fraction(int(fraction[1]), int(fraction[2])) if fraction else decimal(text)
    if not ratio:
        raise Usage(f"not a positive ratio: `{text[:60]}`")
    return ratio


def span(text):
    """The ratios that RATIO or LO:HI stands for."""
    first, colon, last = text.partition(":")
    low = mass_ratio(first)
    high = mass_ratio(last) if colon else low
    if low > high:
        raise Usage(f"LO:HI needs LO <= HI: {text[:60]}")
    return low, high


def mass_ratios(text):
    """The same >= 1: below 1 the masses are swapped."""
    low, high = span(text)
    if low < 1 < high:
        raise Usage(f"a range across 1: split it at 1: {text[:60]}")
    return (1 / high, 1 / low) if low < 1 else (low, high)


def rhos(text):
    low, high = span(text)
    if high > 1:
        raise Usage(f"--rho is at most 1, not {text[:60]}")
    return low, high


def count(option, text):
    """A natural number as long as one in a file may be."""
    if not re.fullmatch(r"0|[1-9][0-9]{0,2099}", text):
        raise Usage(f"{option} needs a number of at most 2100 digits, not `{text[:60]}`")
    return int(text)


def time(option, text):
    """A time as `30s`, `10m` or `1.5h`, in seconds."""
    unit = {"s": 1, "m": 60, "h": 3600}.get(text[-1:])
    number = decimal(text[:-1]) if unit and len(text) <= 1000 else None
    if number is None:
        raise Usage(f"{option} needs a time such as 30s, 10m or 2h, not `{text[:60]}`")
    return number * unit


def one_of(option, words, text):
    if text not in words:
        raise Usage(f"{option} is {', '.join(words[:-1])} or {words[-1]}, not `{text[:60]}`")
    return text


def state(asked, option, value):
    """Takes an option with its value."""
    demand = asked.demand
    if option == "--budget":
        asked.budget = time(option, value)
    elif option == "--ratio":
        demand.ratios = mass_ratios(value)
    elif option == "--rho":
        demand.rhos = rhos(value)
    elif option == "--scene":
        demand.scene = one_of(option, SCENES, value)
    elif option == "--claim":
        demand.claim = one_of(option, CLAIMS, value)
    else:
        number = count(option, value)
        demand.most = demand.most if option == "--min" else number
        demand.least = demand.least if option == "--max" else number


def parse(words):
    """Options are `--name VALUE` or `--name=VALUE`; after `--` there are none."""
    asked, words, seen, ended = Asked(), list(words), set(), False
    while words:
        word = words.pop(0)
        option, equals, value = word.partition("=")
        if word == "--" and not ended:
            ended = True
        elif ended or word == "-" or not word.startswith("-"):
            asked.files.append(word)
        elif word == "--quiet":
            asked.quiet = True
        elif word in ("-h", "--help"):
            asked.answer = HELP
        elif word in ("-V", "--version"):
            asked.answer = f"{NAME} {VERSION}\n"
        elif option not in ("--ratio", "--rho", "--max", "--min", "--exactly", "--scene", "--claim", "--budget"):
            raise Usage(f"unknown option {word}; see --help")
        else:
            if option in seen:
                raise Usage(f"{option} is given twice")
            seen.add(option)
            if "--exactly" in seen and seen & {"--max", "--min"}:
                raise Usage("--exactly N is --max N and --min N: give it without them")
            if not (equals or words):
                raise Usage(f"no value after {option}")
            state(asked, option, value if equals else words.pop(0))
    if not (asked.files or asked.answer):
        raise Usage("no FILE; see --help")
    demand = asked.demand
    if demand.rhos and demand.scene != "body":
        raise Usage("--rho is about --scene body: give both")
    if demand.scene == "body" and (demand.most, demand.least) != (None, None) and not demand.rhos:
        raise Usage("a bound for --scene body needs --rho, such as --rho 1")
    return asked
