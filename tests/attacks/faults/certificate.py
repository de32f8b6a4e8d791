"""What these tests know of certificate files."""

import gzip
import hashlib
from pathlib import Path


def text_of(path: Path) -> bytes:
    data = path.read_bytes()
    return gzip.decompress(data) if path.name.endswith(".gz") else data


def is_whole(text: bytes) -> bool:
    """The last line is the checksum of all lines before it."""
    at = text.rfind(b"sha256 ")
    return at >= 0 and text[at:] == sealed(text[:at])[at:]


def sealed(body: bytes) -> bytes:
    return body + b"sha256 " + hashlib.sha256(body).hexdigest().encode() + b"\n"


def checksum(text: bytes) -> str:
    return text.rstrip(b"\n").rsplit(b" ", 1)[-1].decode()


def claimed_range(text: bytes) -> str:
    """As the verdict spells it."""
    line = next(line for line in text.split(b"\n") if line.startswith(b"ratio "))
    return ":".join(line.decode().split(" ")[1:])
