"""Certificates, with the right checksum, whose trees are very deep."""

import resource
import tempfile
from pathlib import Path

from certificate import sealed
from programs import Programs
from tally import Tally

PATIENCE = 60  # seconds of the processor


def used() -> float:
    """Seconds of the processor, by the programs that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def text(axis: str, splits: int, leaves: int) -> bytes:
    """A tree of this many splits, each of the lower half, with this number of its leaves."""
    lines = ["dumbbell-certificate 1", "generator dumbbell 0.1.0", "lemmas 1", "scene dumbbell", "section turning",
             "claim collisions", "ratio 10/1 10/1", "pieces 1", "piece 10/1 10/1", "bits 53", "upper 4", "chart bridge"]
    lines += [f"split {axis}"] * splits + ["count 1 1"] * leaves
    lines += ["chart light", "count 1 0", "lower 0", f"total split {splits}", f"total count {leaves + 1}",
              "total outside 0", "total meets 0", "total meets-reversed 0", "total equal-masses 0", "total witness 0",
              "total open 0"]
    return sealed("\n".join(lines).encode() + b"\n")


def deep_trees(programs: Programs, levels: int) -> Tally:
    tally = Tally(f"trees {levels} levels deep")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        file = folder / "deep.dbc"
        for axis in ("e", "eta", "q"):
            for leaves in (levels + 1, levels, 0):
                file.write_bytes(text(axis, levels, leaves))
                for command, code in (([programs.verify, file], 1),
                                      ([programs.dumbbell, "plot", "staircase", file, "--out", "a.svg"], 2),
                                      ([programs.dumbbell, "audit", file], 3 if leaves > levels else 2)):
                    start = used()
                    outcome = programs.run(command, folder, memory_kib=4_000_000)
                    tally.injected += 1
                    doing = f"{' '.join(str(word) for word in command[1:2])} (axis {axis}, {leaves} leaves)"
                    tally.expect_code(outcome, {code}, doing)
                    if used() - start > PATIENCE:
                        tally.complain("wrong_codes", f"{doing}: took longer than {PATIENCE} s")
                if (folder / "a.svg").exists():
                    tally.complain("half_written", "a picture of a false tree")
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    print(f"greatest resident memory of a program so far: {peak / 1024:.0f} MiB")
    return tally
