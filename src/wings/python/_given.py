"""What the functions are given, as the library takes it. What cannot be taken raises InputError, of a wrong type one that is a
TypeError, too: the functions in C++ ask these."""
import math
import os
from decimal import Decimal
from numbers import Rational
from operator import index

from ._dumbbell import InputError, _InputTypeError


def _shown(x):
    """For messages: some ints and foreign things have no text."""
    try:
        return repr(x)[:60]
    except Exception:
        return f"a {type(x).__name__}"


def _is_bool(x):
    return isinstance(x, bool) or getattr(x, "dtype", None) == bool  # numpy's, too


def _fraction(numerator, denominator=1):
    numerator, denominator = index(numerator), index(denominator)
    if max(numerator.bit_length(), denominator.bit_length()) > 20000:
        raise OverflowError
    # Python limits the digits of int's own text; that of a Decimal has all.
    return f"{Decimal(numerator)}/{Decimal(denominator)}" if denominator != 1 else str(Decimal(numerator))


def number(x):
    if isinstance(x, str):
        return word(x)
    if isinstance(x, tuple) and len(x) == 2:
        return f"{number(x[0])}:{number(x[1])}"
    try:
        one = x[()] if getattr(x, "ndim", None) == 0 else x  # of numpy
        if isinstance(one, Decimal):
            return str(one)
        if isinstance(one, Rational) and not _is_bool(one):
            return _fraction(one.numerator, one.denominator)
        if not _is_bool(one):
            return _fraction(*one.as_integer_ratio()) if hasattr(one, "as_integer_ratio") else _fraction(one)
    except (ValueError, OverflowError):
        raise InputError(f"{_shown(x)} is infinite, no number, or has too many digits") from None
    except Exception:
        pass
    raise _InputTypeError(f"{_shown(x)} is no exact number: give an int, a Fraction, a Decimal, a float, text such as '9/2' or "
                          "'1:100', or a pair (lo, hi)")


def numbers(xs):
    try:
        each = iter(None if isinstance(xs, (str, bytes, bytearray)) else xs)
    except TypeError:
        raise _InputTypeError(f"{_shown(xs)} is no list of mass ratios: give [10, '9/2'] or another iterable") from None
    return [number(x) for x in each]


def whole(x):
    """The nearest of 64 bits: what is far out of range is so all the same."""
    try:
        if not _is_bool(x):
            return max(-2**63, min(index(x), 2**63 - 1))
    except Exception:
        pass
    raise _InputTypeError(f"{_shown(x)} is no whole number: give an int")


def truth(x):
    if isinstance(x, bool):
        return x
    raise _InputTypeError(f"{_shown(x)} is neither True nor False")


def seconds(x):
    if _is_bool(x) or not hasattr(x, "__float__"):
        raise _InputTypeError(f"{_shown(x)} is no number of seconds: give an int or a float, or None for no budget")
    try:
        time = float(x)
    except Exception:
        time = math.nan
    if not 0 <= time < math.inf:
        raise InputError(f"{_shown(x)} is no budget: give 0 seconds or more, or None for no budget")
    return time


def word(x):
    if isinstance(x, str):
        return x.encode(errors="backslashreplace").decode()
    raise _InputTypeError(f"{_shown(x)} is no text: give a str")


def place(x, words):
    if word(x) not in words:
        raise InputError(f"{_shown(x)} is none of {', '.join(words)}")
    return words.index(x)


def demand(claims):
    """`--ratio=10 --coin`: a claim as dumbbell-verify spells it. What is None is not claimed."""
    names = {"most": "max", "least": "min", "kind": "claim"}
    words = []
    for name, x in claims.items():
        option = "--" + names.get(name, name.replace("_", "-"))
        if name == "coin":
            words += [option] * truth(x)
        elif x is not None:
            words.append(word(f"{option}={number(x)}"))
    for one in words:
        if one.split() != [one]:
            raise InputError(f"{_shown(one)} has a blank in it: give each part of a claim by its own name")
    return " ".join(words)


def path(x):
    try:
        name = os.fsencode(x)
    except TypeError:
        raise _InputTypeError(f"{_shown(x)} is no name of a file: give a str or a PathLike") from None
    except UnicodeError:
        raise InputError(f"{_shown(x)} cannot be the name of a file here") from None
    if b"\0" in name:
        raise InputError(f"{_shown(x)} has a NUL, which no name of a file has")
    return name


def content(x):
    """Of a certificate, which is given as its bytes or as the name of its file."""
    if isinstance(x, (bytes, bytearray, memoryview)):
        return bytes(x)
    try:
        with open(path(x), "rb") as file:
            return file.read()
    except OSError as error:
        raise InputError(f"cannot read {_shown(x)}: {error.strerror}") from None
