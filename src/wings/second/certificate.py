"""A certificate: its first lines, and who judges the rest. format.md, section 2."""

import collisions
import incoming
import initial
from failure import Rejected, Unreadable, Unsupported

WORDS = {
    "lemmas": {"1", "minimal", "body"},
    "scene": {"dumbbell", "body"},
    "section": {"turning", "full", "perpendicular", "cells", "none"},
}


def first_line(lines):
    try:
        return lines.line("dumbbell-certificate", "nat")[0]
    except Rejected as error:
        if error.code == "encoding":
            raise
        raise Rejected(error.line, error.code,
                       f"{error}: not a certificate, whose first line is `dumbbell-certificate 1`") from None


def check(lines, demand, judge):
    """Returns what the file proves if all that it says is certified and it is what was demanded; else raises a Failure.
    judge(condition, numbers, bits, wrong) raises `wrong` unless the condition is certified."""
    version = first_line(lines)
    if version != 1:
        raise Unsupported(f"unknown dumbbell-certificate {version}")
    lines.line("generator", "word", "version")
    header = []
    for key, words in WORDS.items():
        word, = lines.line(key, "any")
        lines.value("nat" if key == "lemmas" and word[0].isdigit() else "word", word)
        if word not in words:
            raise Unsupported(f"unknown {key} {word}")
        header.append(word)
    header = tuple(header)
    if header not in collisions.SECTIONS and header != initial.HEADER:
        raise Unsupported(f"no section {header[2]} of the scene {header[1]} with lemmas {header[0]}")
    claim, = lines.line("claim", "word")
    if claim == "collisions" and header in collisions.SECTIONS:
        proof = collisions.check(lines, header, judge, demand)
    elif claim in ("initial-conditions", "incoming") and header == initial.HEADER:
        if demand.bounds() and not demand["claim"]:
            raise Unreadable("what is demanded is about the collisions of all trajectories; this file is about something else: "
                             f"--claim {claim} asks about the starts in its box", 0)
        proof = (incoming if claim == "incoming" else initial).check(lines, judge, demand)
    else:
        raise Unsupported(f"the claim {claim} is not one that this verifier judges")
    missing = demand.other(header[1], claim) or proof.missing(demand)
    if missing:
        raise lines.wrong("claim-not-proved", missing)
    return proof
