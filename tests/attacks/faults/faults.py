"""Injects faults into dumbbell and dumbbell-verify, and prints what came of them as a table.

usage: faults.py DUMBBELL DUMBBELL-VERIFY [FAULT]...

FAULT is one of FAULTS below; all of them if there is none. DUMBBELL_TEST_SCALE in the environment: how many times as
many as in CI (10 in `./run trust`), 1 unless it is set. Exits 1 if a finished result was lost, a half-written file stood
under its final name, or an exit code was wrong; 77 if nothing could be tried.
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


SCALE = int(os.environ.get("DUMBBELL_TEST_SCALE", "1"))

FAULTS = {
    "killed": lambda programs: [kills.ranges(programs, 20 * SCALE, SEED, signal.SIGKILL)],
    "stopped": lambda programs: [kills.ranges(programs, 5 * SCALE, SEED + 1, signal.SIGTERM)],
    "killed_while_replacing": lambda programs: [kills.single_files(programs, 12 * SCALE, SEED + 2)],
    "full_disk": lambda programs: [places.full_disk(programs, 5 * SCALE, SEED + 3)],
    "unwritable_folder": lambda programs: [places.unwritable_folder(programs, 5 * SCALE, SEED + 4)],
    "replaced_file": lambda programs: [replaced.during_verification(programs, 24 * SCALE, SEED + 5)],
    "deep_trees": lambda programs: [deep_trees.deep_trees(programs, min(200_000 * SCALE, 1_000_000))],
    "no_memory": lambda programs: memory.out_of_memory(programs, 6 * SCALE, SEED + 6),
}


def main() -> int:
    if len(sys.argv) < 3 or not FAULTS.keys() >= set(sys.argv[3:]):
        print(__doc__, file=sys.stderr)
        return 2
    programs = Programs(*sys.argv[1:3])
    tallies = [tally for fault in sys.argv[3:] or FAULTS for tally in FAULTS[fault](programs)]
    print(table(tallies))
    for tally in tallies:
        for complaint in tally.complaints[:20]:
            print(complaint, file=sys.stderr)
    if all(tally.skipped for tally in tallies):
        return 77
    return 0 if all(tally.passed for tally in tallies) else 1


if __name__ == "__main__":
    sys.exit(main())
