"""Certificates changed on purpose, with totals and checksum made right again, so that neither hides what is wrong."""

import collections
import hashlib

from grammar import unpacked


def body(path):
    """The lines of a certificate before its checksum."""
    with open(path, "rb") as file:
        return unpacked(file.read()).decode().split("\n")[:-2]


def signed(lines):
    text = "".join(line + "\n" for line in lines).encode()
    return text + b"sha256 " + hashlib.sha256(text).hexdigest().encode() + b"\n"


def recounted(lines):
    """The same lines with the totals of the others."""
    counts = collections.Counter(line.split(" ")[0] for line in lines)
    counts["open"] += sum(line == "upper none" for line in lines)
    if "claim initial-conditions" in lines or "claim incoming" in lines:
        counts["between"] -= 1  # the header has such a line, too
    return [f"total {line.split(' ')[1]} {counts[line.split(' ')[1]]}" if line.startswith("total ") and line.count(" ") == 2
            else line for line in lines]
