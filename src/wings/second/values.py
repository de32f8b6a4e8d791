"""The values of options: what a text of the command line or of a list stands for, exactly. Each reader takes the option's name,
which its message repeats, and the text."""

import re
from fractions import Fraction


class Usage(Exception):
    """What is wrong with the command line."""


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


def size(text):
    """What a decimal or a fraction without a sign stands for; None of other texts."""
    if len(text) > 2100:
        return None
    fraction = re.fullmatch(r"([0-9]+)/([0-9]*[1-9][0-9]*)", text)
    return Fraction(int(fraction[1]), int(fraction[2])) if fraction else decimal(text)


def ratio(_option, text):
    value = size(text)
    if not value:
        raise Usage(f"not a positive ratio: `{text[:60]}`")
    return value


def number(fits, words):
    """The reader of numbers with a sign that fit; `words` say which do."""
    def read(option, text):
        sign = -1 if text.startswith("-") else 1
        value = size(text[1:] if sign < 0 else text)
        if value is None or (sign < 0 and not fits(-1)) or not fits(sign * value):
            raise Usage(f"{option} needs {words}, not `{text[:60]}`")
        return sign * value
    return read


def span(read):
    """The reader of VALUE or LO:HI: both ends."""
    def read_span(option, text):
        first, colon, last = text.partition(":")
        low = read(option, first)
        high = read(option, last) if colon else low
        if low > high:
            raise Usage(f"LO:HI needs LO <= HI: {text[:60]}")
        return low, high
    return read_span


def one_or_two(read):
    """The reader of A or A,B."""
    return lambda option, text: tuple(read(option, part) for part in text.split(",", 1))


def mass_ratios(option, text):
    """RATIO or LO:HI as mass ratios >= 1: below 1 the masses are swapped."""
    low, high = span(ratio)(option, text)
    if low < 1 < high:
        raise Usage(f"a range across 1: split it at 1: {text[:60]}")
    return (1 / high, 1 / low) if low < 1 else (low, high)


def count(option, text):
    """A natural number as long as one in a file may be."""
    if not re.fullmatch(r"0|[1-9][0-9]{0,2099}", text):
        raise Usage(f"{option} needs a number of at most 2100 digits, not `{text[:60]}`")
    return int(text)


def time(option, text):
    """A time as `30s`, `10m` or `1.5h`, in seconds."""
    unit = {"s": 1, "m": 60, "h": 3600}.get(text[-1:])
    seconds = decimal(text[:-1]) if unit and len(text) <= 1000 else None
    if seconds is None:
        raise Usage(f"{option} needs a time such as 30s, 10m or 2h, not `{text[:60]}`")
    return seconds * unit


def one_of(*words):
    """The reader of these words."""
    def read(option, text):
        if text not in words:
            raise Usage(f"{option} is {' or '.join(', '.join(words).rsplit(', ', 1))}, not `{text[:60]}`")
        return text
    return read
