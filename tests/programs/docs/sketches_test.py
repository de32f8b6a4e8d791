#!/usr/bin/env python3
"""sketches_test.py BIN: the sketches of docs/pictures, and the law and the scattering there, are what their scripts draw."""
import os
import pathlib
import re
import subprocess
import sys

PICTURES = pathlib.Path(__file__).resolve().parents[3] / "docs/pictures"
OF_PROOFS = ["law", "scattering"]


def drawn(*command):
    environment = dict(os.environ, DUMBBELL=f"{sys.argv[1]}/dumbbell")
    return subprocess.check_output([sys.executable, *command], text=True, env=environment)


def without_digits(text):
    """Another C library may round a length otherwise."""
    return re.sub(r"[-0-9.]|e-", "", text)


def main():
    names = re.search(r"^        ([a-z |]+)\) docs/pictures/schematic ", (PICTURES / "draw").read_text(), re.M)[1].split(" | ")
    stale = [name for name in names if (PICTURES / f"{name}.svg").read_text() != drawn(PICTURES / "schematic", name)]
    stale += [name for name in OF_PROOFS
              if without_digits((PICTURES / f"{name}.svg").read_text()) != without_digits(drawn(PICTURES / f"{name}-picture"))]
    print(f"draw again: {', '.join(stale)}" if stale else f"{len(names) + len(OF_PROOFS)} pictures are as they are drawn")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
