#!/usr/bin/env python3
"""sketches_test.py: the sketches of docs/pictures are what docs/pictures/schematic draws."""
import pathlib
import re
import subprocess
import sys

PICTURES = pathlib.Path(__file__).resolve().parents[3] / "docs/pictures"


def main():
    names = re.search(r"^        ([a-z |]+)\) docs/pictures/schematic ", (PICTURES / "draw").read_text(), re.M)[1].split(" | ")
    stale = [name for name in names
             if (PICTURES / f"{name}.svg").read_text() != subprocess.check_output([sys.executable, PICTURES / "schematic", name], text=True)]
    print(f"draw again: {', '.join(stale)}" if stale else f"{len(names)} sketches are as they are drawn")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
