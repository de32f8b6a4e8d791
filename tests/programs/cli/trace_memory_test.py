"""Boxes of `trace --subdivide` and lines of its certificate cost little memory."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

BYTES_OF_A_BOX = 60


def peak(dumbbell: str, boxes: int, folder: str) -> int:
    """The greatest resident memory, in bytes."""
    command = [dumbbell, "trace", "10", "--phi", "0:3", "--phidot=-1/2:1/2", "--y", "3/2", "--ydot=-1", "--subdivide",
               "--max-boxes", str(boxes), "--jobs", "1", "--quiet", "--out", Path(folder) / "falling.dbc"]
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    assert status == 0, status
    return usage.ru_maxrss * 1024


with tempfile.TemporaryDirectory() as scratch:
    few, many = 10_000, 50_000
    more = peak(sys.argv[1], many, scratch) - peak(sys.argv[1], few, scratch)
    print(f"{more / (many - few):.1f} bytes of a box")
    sys.exit(more > BYTES_OF_A_BOX * (many - few))
