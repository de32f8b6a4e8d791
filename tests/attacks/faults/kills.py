"""The program is killed, or asked to stop, at random moments while it writes a file."""

import random
import signal
import tempfile
import time
from pathlib import Path

from certificate import is_whole
from programs import Programs, after, once_there
from tally import Tally

RANGE = ["certify", "1:3000", "--gap", "1e-12", "--out", "stairs.dbc"]


class Kept:
    """The finished pieces in a folder: once there, they stay until the file is there."""

    def __init__(self, folder: Path):
        self.file = folder / "stairs.dbc"
        self.partial = folder / "stairs.dbc.partial"
        self.pieces: dict[str, bytes] = {}

    def look(self, tally: Tally) -> None:
        now = {path.name: path.read_bytes() for path in self.partial.glob("*.dbc")} if self.partial.is_dir() else {}
        for name, text in now.items():
            if not is_whole(text):
                tally.complain("half_written", f"the piece {name}")
        if not self.file.exists():
            for name, text in self.pieces.items():
                if now.get(name) != text:
                    tally.complain("lost", f"the piece {name}")
        self.pieces = now


def random_moment(dice: random.Random, folder: Path, seconds: float):
    """Anywhere in the run; or, since these last for milliseconds only, while the file is being written or pieces go."""
    kind = dice.random()
    if kind < 0.7:
        return after(dice.uniform(0, 1.2 * seconds))
    if kind < 0.85:
        return once_there(folder / "stairs.dbc.dumbbell-tmp", 3 * seconds)
    return once_there(folder / "stairs.dbc", 3 * seconds)


def ranges(programs: Programs, count: int, seed: int, number: int) -> Tally:
    """`certify LO:HI --out FILE`, ended by signal `number` and called again until it is done, `count` times in all."""
    dice = random.Random(seed)
    by = "kill -9" if number == signal.SIGKILL else signal.Signals(number).name
    tally = Tally(f"{by} while certify LO:HI --out FILE runs")
    command = [programs.dumbbell, *RANGE]
    with tempfile.TemporaryDirectory() as name:
        start = time.monotonic()
        undisturbed = programs.run(command, name)
        seconds = time.monotonic() - start
        tally.expect_code(undisturbed, {0}, "undisturbed")
        whole = (Path(name) / "stairs.dbc").read_bytes()
    while tally.injected < count:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            file = folder / "stairs.dbc"
            kept = Kept(folder)
            while not file.exists() and tally.injected < count:
                outcome = programs.run_killed(command, folder, random_moment(dice, folder, seconds), number)
                tally.injected += outcome.code != 0
                tally.expect_code(outcome, {0, -number}, "ended by the signal")
                if file.exists() and file.read_bytes() != whole:
                    tally.complain("half_written", "stairs.dbc")
                kept.look(tally)
            tally.expect_code(programs.run(command, folder), {0}, "called again")
            if file.read_bytes() != whole:
                tally.complain("lost", "the bytes are others than undisturbed")
            if (names := sorted(path.name for path in folder.iterdir())) != ["stairs.dbc"]:
                tally.complain("half_written", f"left in the end: {names}")
    return tally


def single_files(programs: Programs, count: int, seed: int) -> Tally:
    """Short runs that replace a file: the old one or the new one stands there, whole."""
    dice = random.Random(seed)
    tally = Tally("kill -9 while a file is replaced")
    commands = [("file.dbc", ["certify", "10"]), ("file.dbc", ["certify", "100", "--section", "full"]),
                ("file.tsv", ["critical", "3:6"]),
                ("file.dbc", ["trace", "10", "--phi", "0.3:0.31", "--phidot", "0", "--y", "3/2", "--ydot", "-1",
                              "--subdivide"])]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for turn in range(count):
            written, words = commands[turn % len(commands)]
            command = [programs.dumbbell, *words, "--out", written]
            for left in folder.iterdir():
                left.unlink()
            file = folder / written
            start = time.monotonic()
            tally.expect_code(programs.run(command, folder), {0}, " ".join(words))
            seconds = time.monotonic() - start
            new = file.read_bytes()
            file.write_bytes(b"old\n")
            moment = (once_there(folder / f"{written}.dumbbell-tmp", 3 * seconds) if dice.random() < 0.3 else
                      after(dice.uniform(0, 1.2 * seconds)))
            outcome = programs.run_killed(command, folder, moment)
            tally.injected += outcome.code != 0
            tally.expect_code(outcome, {0, -signal.SIGKILL}, " ".join(words))
            if file.read_bytes() not in ((new,) if outcome.code == 0 else (b"old\n", new)):
                tally.complain("half_written", " ".join(words))
            tally.expect_code(programs.run(command, folder), {0}, "called again")
            if file.read_bytes() != new or len(list(folder.iterdir())) != 1:
                tally.complain("lost", f"called again, {words} leaves {sorted(folder.iterdir())}")
    return tally
