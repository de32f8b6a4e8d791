"""The place that is written to fails: the disk is full, the folder cannot be written, or no longer."""

import os
import random
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from kills import RANGE, Kept
from programs import Programs, after, ended
from tally import Tally

NOBODY = 65534


class SmallDisk:
    """A file system of some kilobytes; only root can have one."""

    def __init__(self, place: Path, kib: int):
        self.place = place
        self.kib = kib

    def __enter__(self) -> "SmallDisk | None":
        made = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={self.kib}k", "tmpfs", self.place],
                              stderr=subprocess.DEVNULL, check=False)
        self.mounted = made.returncode == 0
        return self if self.mounted else None

    def grow(self) -> None:
        subprocess.run(["mount", "-o", "remount,size=64m", self.place], check=True)

    def __exit__(self, *_) -> None:
        if self.mounted:
            subprocess.run(["umount", self.place], check=True)


def undisturbed(programs: Programs) -> tuple[bytes, float]:
    with tempfile.TemporaryDirectory() as name:
        start = time.monotonic()
        programs.run([programs.dumbbell, *RANGE], name)
        return (Path(name) / "stairs.dbc").read_bytes(), time.monotonic() - start


def goes_on(programs: Programs, tally: Tally, folder: Path, whole: bytes, kept: Kept, **limits) -> None:
    """Once the place can be written again nothing was lost."""
    kept.look(tally)
    tally.expect_code(programs.run([programs.dumbbell, *RANGE], folder, **limits), {0}, "with the place in order")
    if not kept.file.exists() or kept.file.read_bytes() != whole:
        tally.complain("lost", "the bytes are others than undisturbed")


def full_disk(programs: Programs, count: int, seed: int) -> Tally:
    dice = random.Random(seed)
    tally = Tally("disk full")
    whole, _ = undisturbed(programs)
    for turn in range(count):
        with tempfile.TemporaryDirectory() as name:
            place = Path(name)
            old = turn % 2 == 1
            with SmallDisk(place, 4 * round(2 * 40 ** dice.random())) as disk:  # the run needs some 60 pages
                if disk is None:
                    tally.skipped = "only root can mount a small disk"
                    return tally
                kept = Kept(place)
                if old:
                    kept.file.write_bytes(b"old\n")
                outcome = programs.run([programs.dumbbell, *RANGE], place)
                if outcome.code == 0:
                    continue  # it was large enough
                tally.injected += 1
                tally.expect_code(outcome, {2}, "a full disk")
                if outcome.err.count("\n") != 1 or "No space left" not in outcome.err:
                    tally.complain("wrong_codes", f"a full disk: it said {outcome.err!r}")
                if (kept.file.read_bytes() if kept.file.exists() else None) != (b"old\n" if old else None):
                    tally.complain("half_written", "stairs.dbc")
                disk.grow()
                goes_on(programs, tally, place, whole, kept)
    if tally.injected == 0:
        tally.complain("wrong_codes", "no disk was too small: nothing was tried")
    return tally


def unwritable_folder(programs: Programs, count: int, seed: int) -> Tally:
    """As an unprivileged user, from the beginning or from a random moment on."""
    dice = random.Random(seed)
    tally = Tally("folder not writable (any more)")
    whole, seconds = undisturbed(programs)
    user = NOBODY if os.geteuid() == 0 else None
    with tempfile.TemporaryDirectory() as name:
        os.chmod(name, 0o755)
        copies = [shutil.copy(program, name) for program in (programs.dumbbell, programs.verify)]
        theirs = Programs(*copies)
        for turn in range(count):
            folder = Path(name) / f"place-{turn}"
            folder.mkdir()
            if user is not None:
                os.chown(folder, user, user)
            kept = Kept(folder)
            early = turn % 3 == 0
            if early:
                folder.chmod(0o555)
            process = theirs.start([theirs.dumbbell, *RANGE], folder, user=user)
            if not early:
                after(dice.uniform(0, seconds))(process)
                folder.chmod(0o555)
            outcome = ended(process)
            if early and "cannot start" in outcome.err:
                tally.skipped = "an unprivileged user cannot run the programs"
                return tally
            tally.injected += outcome.code != 0
            tally.expect_code(outcome, {2} if early else {0, 2}, "a folder that cannot be written")
            if kept.file.exists() and kept.file.read_bytes() != whole:
                tally.complain("half_written", "stairs.dbc")
            folder.chmod(0o755)
            goes_on(theirs, tally, folder, whole, kept, user=user)
    return tally
