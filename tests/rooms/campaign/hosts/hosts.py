"""Campaigns on Work Queue over several hosts, which are network namespaces of this machine, and faults of all kinds.

usage: hosts.py DUMBBELL DUMBBELL-VERIFY CASE

CASE is the name of a file in cases/. Exits 1 if it did not end as it must.
"""

import importlib
import os
import sys
import time
from pathlib import Path

import world
from checks import Failed
from place import Place

LONGEST_TAIL = 2000  # characters of each file that a failure prints


def show(folder: Path) -> None:
    """What was said and written, for those who have to find the cause."""
    for file in sorted(file for pattern in ("*.err", "*.json", "*.log", "*/journal") for file in folder.glob(pattern)):
        print(f"--- {file.relative_to(folder)}\n{file.read_text(errors='replace')[-LONGEST_TAIL:]}", file=sys.stderr)


def main() -> int:
    if len(sys.argv) != 4:
        print(__doc__, file=sys.stderr)
        return 2
    program, verifier, case = sys.argv[1:]
    folder = Path(world.enter())
    os.environ["TMPDIR"] = "/run"  # a manager that is killed leaves its copy of the program there
    os.environ["ASAN_OPTIONS"] = "detect_leaks=0"  # Work Queue's library leaks some bytes
    begin = time.monotonic()
    try:
        importlib.import_module(f"cases.{case}").run(Place(program, verifier, folder))
    except Failed as failure:
        show(folder)
        print(f"{case}: {failure}", file=sys.stderr)
        return 1
    print(f"{case}: passed in {time.monotonic() - begin:.1f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
