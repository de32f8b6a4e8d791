"""The lines of a certificate and the spelling of its values: format.md, sections 1 and 2."""

import hashlib
import re
import zlib
from fractions import Fraction
from math import gcd

GREATEST_TEXT = 1 << 28


class Rejected(Exception):
    """What the format does not allow; `line` is the number of the line, 0 if there is none."""

    def __init__(self, line, reason):
        super().__init__(reason)
        self.line = line


class Unsupported(Exception):
    """A foreign version, claim kind, scene, section or lemma set."""


class Limit(Exception):
    """More work or memory than this program is willing to spend."""


def unpacked(data):
    """The text of a file, which may be one gzip member."""
    if not data.startswith(b"\x1f\x8b"):
        return data
    member = zlib.decompressobj(wbits=31)
    try:
        text = member.decompress(data, GREATEST_TEXT)
    except zlib.error as error:
        raise Rejected(0, f"not a gzip file: {error}") from None
    if len(text) >= GREATEST_TEXT:
        raise Limit("the text is too long")
    if not member.eof or member.unused_data:
        raise Rejected(0, "not exactly one gzip member")
    return text


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


def _count(text):
    return int(_matching(r"0|[1-9][0-9]{0,2099}")(text))


def _lemmas(text):
    """A nat, or a word."""
    return text if text[0].islower() and CLASSES["word"](text) else str(_nat(text))


CLASSES = {
    "nat": _nat,
    "count": _count,
    "lemmas": _lemmas,
    "ratio": _ratio,
    "signed": _signed,
    "dyadic": _dyadic,
    "word": _matching(r"[a-z][a-z0-9.-]{0,31}"),
    "version": _matching(r"[a-z0-9][a-z0-9.-]{0,31}"),
    "hex64": _matching(r"[0-9a-f]{64}"),
}


class Lines:
    """Hands out the lines of a text one by one; `number` is that of the last line handed out."""

    def __init__(self, text):
        self._text = text
        self._lines = text.split(b"\n")  # the last one is what follows the last line feed
        self.number = 0
        self.totals = {}

    def wrong(self, reason):
        return Rejected(self.number, reason)

    def next(self):
        """The fields of the next line."""
        self.number += 1
        if self.number >= len(self._lines):
            raise self.wrong("the text ends too early, or without a line feed")
        line = self._lines[self.number - 1]
        if len(line) > 4096 or re.search(rb"[^ -~]", line):
            raise self.wrong("a byte that is not allowed, or a line over 4096 bytes")
        fields = line.decode("ascii").split(" ")
        if "" in fields:
            raise self.wrong("an empty line or a space too many")
        return fields

    def values(self, fields, *classes):
        """The values of the fields, which must be as many as the classes, and spelled like them."""
        if len(fields) != len(classes):
            raise self.wrong("too few or too many fields")
        try:
            return [CLASSES[name](text) for name, text in zip(classes, fields)]
        except ValueError:
            raise self.wrong(f"not of the classes {' '.join(classes)}") from None

    def line(self, words, *classes):
        """The values of the next line, which must begin with the words."""
        words, fields = words.split(" "), self.next()
        if fields[:len(words)] != words:
            raise self.wrong(f"expected `{' '.join(words)}`")
        return self.values(fields[len(words):], *classes)

    def count(self, kind):
        self.totals[kind] = self.totals.get(kind, 0) + 1

    def trailer(self, kinds):
        """The totals, the checksum and the end of the file; returns the checksum."""
        for kind in kinds:
            if self.line(f"total {kind}", "nat") != [self.totals.get(kind, 0)]:
                raise self.wrong(f"the total of {kind} is {self.totals.get(kind, 0)}")
        before = sum(len(line) + 1 for line in self._lines[:self.number])
        checksum, = self.line("sha256", "hex64")
        if checksum != hashlib.sha256(self._text[:before]).hexdigest():
            raise self.wrong("the checksum is another")
        if self._lines[self.number:] != [b""]:
            raise Rejected(self.number + 1, "something follows the checksum")
        return checksum
