"""Injects faults into dumbbell and dumbbell-verify, and prints what came of them as a table.

usage: faults.py DUMBBELL DUMBBELL-VERIFY

DUMBBELL_FAULTS_SCALE in the environment: how many times as many as in CI (10 in `./run trust`), 1 unless it is set.
Exits 1 if a finished result was lost, a half-written file stood under its final name, or an exit code was wrong.
"""

import os
import signal
import sys

import deep_trees
import kills
import memory
import places
import replaced
from programs import Programs
from tally import table

SEED = 20260101


def main() -> int:
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    programs = Programs(*sys.argv[1:])
    scale = int(os.environ.get("DUMBBELL_FAULTS_SCALE", "1"))
    tallies = [
        kills.ranges(programs, 20 * scale, SEED, signal.SIGKILL),
        kills.ranges(programs, 5 * scale, SEED + 1, signal.SIGTERM),
        kills.single_files(programs, 12 * scale, SEED + 2),
        places.full_disk(programs, 5 * scale, SEED + 3),
        places.unwritable_folder(programs, 5 * scale, SEED + 4),
        replaced.during_verification(programs, 24 * scale, SEED + 5),
        deep_trees.deep_trees(programs),
        *memory.out_of_memory(programs, 6 * scale, SEED + 6),
    ]
    print(table(tallies))
    for tally in tallies:
        if tally.skipped:
            print(f"SKIPPED: {tally.fault}: {tally.skipped}", file=sys.stderr)
        for complaint in tally.complaints[:20]:
            print(complaint, file=sys.stderr)
    return 0 if all(tally.passed for tally in tallies) else 1


if __name__ == "__main__":
    sys.exit(main())
