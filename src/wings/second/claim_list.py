"""`--claims`: a list of certificates, each with the claim that it must prove."""

import os
import re

import claim_options
from failure import Failure
from grammar import foreign
from source import read
from values import Usage

GREATEST_LIST = 1 << 24  # bytes


def read_claims(path):
    """Of each row its file and its demand. A row is a certificate, a tab, the options that state its claim, and remarks behind
    further tabs; empty lines and lines that begin with # are remarks. Raises Usage, which names the row."""
    rows, where = [], path
    # If the list is no file on a disk, names are relative to the folder where the program runs.
    is_pipe = re.match("-$|/dev/stdin$|/dev/fd/|/proc/", path) or not os.path.isfile(path)
    folder = "" if is_pipe else os.path.dirname(path)
    try:
        text = read(path)
        if len(text) > GREATEST_LIST:
            raise Usage("a list of claims has at most 16 MiB")
        for number, line in enumerate(text.split(b"\n"), 1):
            where = f"{path}:{number}"
            named = foreign(line, number)
            if named:
                raise Usage(named)
            if line and not line.startswith(b"#"):
                rows.append(row(os.fsdecode(line).split("\t"), folder))
        where = path
        if not rows:
            raise Usage("no claim in this list")
    except (Usage, Failure) as error:
        raise Usage(f"{where}: {error}") from None
    return rows


def row(fields, folder):
    name, *claim = fields
    if not (name and claim and claim[0]):
        raise Usage("needs a certificate, a tab and its claim: FILE<tab>--ratio 10 --max 4")
    if "\0" in name:
        raise Usage("a name with a zero byte")
    words, given = re.sub(" $", "", claim[0]).split(" "), {}
    while words:
        word = words.pop(0)
        if not claim_options.take(word, words, given):
            raise Usage(f"`{word[:60]}` states no claim; see --help")
    if any(re.match("[^-0-9A-Za-z]*--", remark) for remark in claim[1:]):  # behind blanks, quotes and the like
        raise Usage("a demand behind the second tab, where remarks are: put it before")
    demand = claim_options.demand_of(given)
    if not is_whole(demand):
        raise Usage("the claim needs --ratio or a body, and a bound or --decided; or --delta and --constant; or it is --claim law")
    return name if name == "-" else os.path.join(folder, name), demand


def is_whole(demand):
    """Less would be verified, whatever the file proves."""
    if demand["delta"]:
        return "constant" in demand
    return demand["claim"] == "law" or (("ratio" in demand or "inertia" in demand)
                                        and ("max" in demand or demand["min"] or demand["decided"]))
