"""The file is replaced while it is verified: a verdict is about one content, and says about which."""

import os
import random
import re
import tempfile
import time
from pathlib import Path

from certificate import checksum, claimed_range, text_of
from programs import Programs, after, ended
from tally import Tally


def replace(file: Path, other: bytes, how: str) -> None:
    if how == "another one renamed over it":
        beside = file.with_name("beside")
        beside.write_bytes(other)
        os.replace(beside, file)
    elif how == "overwritten":
        with open(file, "r+b") as stream:
            stream.write(other)
            stream.truncate()
    elif how == "truncated":
        os.truncate(file, len(other) // 3)
    else:
        with open(file, "ab") as stream:
            stream.write(other)


WAYS = ("another one renamed over it", "overwritten", "truncated", "appended to")


def check_verdict(tally: Tally, outcome, contents: dict[str, str], how: str) -> None:
    if how == WAYS[0]:
        tally.expect_code(outcome, {0}, how)
    else:
        tally.expect_code(outcome, {0, 1}, how)
    line = outcome.last_line
    if (outcome.code == 0) != line.startswith("s VERIFIED "):
        tally.complain("wrong_codes", f"{how}: exit {outcome.code} with {line!r}")
    if outcome.code == 0:
        ratio, digest = re.search(r" ratio=(\S+) ", line).group(1), re.search(r" sha256=(\S+)", line).group(1)
        if contents.get(digest) != ratio:
            tally.complain("wrong_codes", f"{how}: a verdict about what was never there: {line!r}")


def during_verification(programs: Programs, count: int, seed: int) -> Tally:
    dice = random.Random(seed)
    tally = Tally("file replaced during verification")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for suffix in (".dbc", ".dbc.gz"):
            files = []
            for ratio in ("1:30000", "2:20000"):
                files.append(folder / (ratio.replace(":", "-") + suffix))
                programs.run([programs.dumbbell, "certify", ratio, "--gap", "1e-9", "--out", files[-1]], folder)
            contents = {checksum(text_of(file)): claimed_range(text_of(file)) for file in files}
            first, second = (file.read_bytes() for file in files)
            file = folder / ("file" + suffix)
            start = time.monotonic()
            programs.run([programs.verify, files[0]], folder)
            seconds = time.monotonic() - start
            for turn in range(count // 2):
                how = WAYS[turn % len(WAYS)]
                file.write_bytes(first)
                process = programs.start([programs.verify, file], folder)
                after(dice.uniform(0, seconds))(process)
                tally.injected += process.poll() is None
                replace(file, second, how)
                check_verdict(tally, ended(process), contents, how)
    return tally
