"""The memory runs out: a limit on the address space, at random between too little to start and enough."""

import random
import shutil
import tempfile
from pathlib import Path

from programs import Programs
from tally import Tally


def least_to_start(programs: Programs, command, folder) -> int:
    """KiB with which the system can load the program."""
    low, high = 1_000, 4_000_000
    while high - low > 500:
        middle = (low + high) // 2
        if programs.run(command, folder, memory_kib=middle).loader_failed:
            low = middle
        else:
            high = middle
    return high


def enough(programs: Programs, command, folder, start: int) -> int:
    """KiB with which it succeeds, as it does without a limit."""
    limit = start
    while programs.run(command, folder, memory_kib=limit).code != 0:
        limit = limit * 3 // 2
    return limit


def out_of_memory(programs: Programs, count: int, seed: int) -> list[Tally]:
    dice = random.Random(seed)
    tallies = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shown = folder / "shown.dbc.gz"
        programs.run([programs.dumbbell, "certify", "1:3000", "--gap", "1e-9", "--out", shown], folder)
        file, table = folder / "file.dbc", folder / "file.tsv"
        prover = Tally("out of memory: prover")
        verifier = Tally("out of memory: verifier")
        commands = (
            (prover, [programs.dumbbell, "certify", "1:3000", "--gap", "1e-9", "--jobs", "2", "--out", file], {0, 1}),
            (prover, [programs.dumbbell, "certify", "12", "--section", "plain", "--jobs", "2",
                      "--out", file], {0, 1}),
            (prover, [programs.dumbbell, "critical", "3:20", "--digits", "100", "--jobs", "2", "--out", table], {0, 1}),
            (verifier, [programs.verify, "--jobs", "2", shown], {0, 4}),
            (verifier, [programs.verify, "--jobs", "1", "--json", shown], {0, 4}))
        for tally, command, codes in commands:
            file = command[-1] if tally is prover else folder / "none"
            # What the command before has kept of a run that memory failed.
            shutil.rmtree(f"{file}.partial", ignore_errors=True)
            unlimited = programs.run(command, folder)
            tally.expect_code(unlimited, {0}, f"{command[1]} without a limit")
            if unlimited.code != 0:
                continue
            whole = file.read_bytes() if tally is prover else b""
            least = least_to_start(programs, [command[0], "--version"], folder)
            most = enough(programs, command, folder, least)
            file.unlink(missing_ok=True)
            for _ in range(count):
                limit = dice.randint(least, most)
                outcome = programs.run(command, folder, memory_kib=limit)
                if outcome.loader_failed:
                    continue
                tally.injected += outcome.code != 0
                tally.expect_code(outcome, codes, f"{command[1]} with {limit} KiB")
                if file.exists() and file.read_bytes() != whole:
                    tally.complain("half_written", f"{command[1]} with {limit} KiB")
                if outcome.code == 0 and tally is prover and not file.exists():
                    tally.complain("lost", f"{command[1]} with {limit} KiB")
                file.unlink(missing_ok=True)
        tallies = [prover, verifier]
    return tallies
