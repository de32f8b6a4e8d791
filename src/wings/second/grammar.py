"""The lines of a certificate and the spelling of its values: format.md, sections 1 and 2."""

import hashlib
import re
from fractions import Fraction
from math import gcd

from failure import Rejected
from work import spend

GREATEST_LINE = 4096  # bytes, with its line feed


def _ratio(text):
    match = re.fullmatch(r"([1-9][0-9]{0,2099})/([1-9][0-9]{0,2099})", text)
    if match:
        over, under = int(match[1]), int(match[2])
        if gcd(over, under) == 1:
            return Fraction(over, under)
    raise ValueError


def _signed(text):
    return Fraction(0) if text == "0/1" else -_ratio(text[1:]) if text.startswith("-") else _ratio(text)


def _dyadic(text):
    match = re.fullmatch(r"([1-9][0-9]{0,1249})b(0|-?[1-9][0-9]{0,3})", text)
    if match and int(match[1]) % 2 and abs(int(match[2])) <= 4096:
        return int(match[1]) * Fraction(2) ** int(match[2])
    if text == "0b0":
        return Fraction(0)
    raise ValueError


def _matching(pattern):
    def parse(text):
        if re.fullmatch(pattern, text):
            return text
        raise ValueError
    return parse


def _nat(text):
    return int(_matching(r"0|[1-9][0-9]{0,17}")(text))


def _bits(text):
    if 53 <= _nat(text) <= 4096:
        return _nat(text)
    raise ValueError


def _count(text):
    return int(_matching(r"0|[1-9][0-9]{0,2099}")(text))


# Of each class of values: how it is read, and the code of the failure if it is misspelled.
CLASSES = {
    "any": (str, ""),
    "nat": (_nat, "number"),
    "bits": (_bits, "number"),
    "count": (_count, "number"),
    "ratio": (_ratio, "number"),
    "signed": (_signed, "number"),
    "dyadic": (_dyadic, "number"),
    "word": (_matching(r"[a-z][a-z0-9.-]{0,31}"), "word"),
    "version": (_matching(r"[a-z0-9][a-z0-9.-]{0,31}"), "word"),
}


def foreign(line, number):
    """What another system has made of a text, and how to mend it; None if it is nothing of that kind."""
    if number == 1 and line[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return "the text is UTF-16: mend it with iconv -f UTF-16 -t ASCII <OLD >NEW"
    if number == 1 and line[:3] == b"\xef\xbb\xbf":
        return "the text begins with a byte-order mark of UTF-8: mend it with tail -c +4 <OLD >NEW"
    if b"\r" in line:
        return "the text has line ends of Windows (CR LF): mend it with tr -d '\\r' <OLD >NEW"
    return None


class Lines:
    """Hands out the lines of a text one by one; `number` is that of the last line handed out. `ends` is the failure with which
    the text ends, if it ends with one; watch(number) is called at each line."""

    def __init__(self, text, ends=None, watch=lambda number: None):
        self._text, self._ends, self._watch = text, ends, watch
        self._at = self._begin = 0  # of what follows the present line, and of that line
        self.number = 0
        self.totals = {}

    def wrong(self, code, reason):
        return Rejected(self.number, code, reason)

    def next(self):
        """The fields of the next line."""
        self.number += 1
        self._watch(self.number)
        self._begin, end = self._at, self._text.find(b"\n", self._at, self._at + GREATEST_LINE)
        line = self._text[self._at:self._at + GREATEST_LINE + 1 if end < 0 else end]
        if re.search(rb"[^ -~\n]", line):
            named = foreign(line, self.number)
            raise self.wrong("encoding", named) if named else self.wrong("byte", "not printable ASCII")
        if end < 0:
            if len(line) > GREATEST_LINE:
                raise self.wrong("line", "more than 4096 bytes")
            raise self._ends or self.wrong("truncated", "the text ends too early")
        self._at = end + 1
        spend(1500 + 30 * len(line))  # long numbers are read, and compared later
        fields = line.decode("ascii").split(" ")
        if "" in fields:
            raise self.wrong("line", "empty, or a space too many")
        return fields

    def values(self, fields, *classes):
        """The values of the fields, which must be as many as the classes, and spelled like them."""
        if len(fields) != len(classes):
            raise self.wrong("syntax", "too few or too many values")
        return [self.value(name, text) for name, text in zip(classes, fields)]

    def value(self, name, text):
        """A field as a value of this class."""
        read, code = CLASSES[name]
        try:
            return read(text)
        except ValueError:
            raise self.wrong(code, f"not of the class `{name}`") from None

    def line(self, keyword, *classes):
        """The values of the next line, which must begin with the keyword."""
        fields = self.next()
        if fields[0] != keyword or len(fields) != 1 + len(classes):
            raise self.wrong("syntax", f"expected `{keyword}` with {len(classes)} value(s)")
        return self.values(fields[1:], *classes)

    def count(self, kind):
        self.totals[kind] = self.totals.get(kind, 0) + 1

    def trailer(self, kinds):
        """The totals, the checksum and the end of the file; returns the checksum."""
        for kind in kinds:
            found, number = self.line("total", "any", "any")
            if found != kind or self.value("nat", number) != self.totals.get(kind, 0):
                raise self.wrong("total", f"expected {kind} {self.totals.get(kind, 0)}")
        checksum, = self.line("sha256", "any")
        expected = hashlib.sha256(memoryview(self._text)[:self._begin]).hexdigest()
        if checksum != expected:
            raise self.wrong("sha256", f"expected {expected}")
        if self._at != len(self._text):
            raise self.wrong("trailing", "bytes after the last line")
        if self._ends:
            raise self._ends
        return checksum
