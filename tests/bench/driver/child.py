"""Runs a program of the project, and measures it."""
import os
import statistics
import subprocess
import sys
import tempfile
import time


def once(command):
    """One run: stdout, exit code, seconds of wall and of CPU time (user), peak memory in MB."""
    begin = time.monotonic()
    with tempfile.TemporaryFile("w+") as errors:
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, text=True) as process:
            stdout = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.monotonic() - begin
        errors.seek(0)
        if process.returncode != 0:
            raise RuntimeError(f"exit code {process.returncode} of: {' '.join(map(str, command))}\n{errors.read().strip()}")
    # What this driver occupied between fork and exec counts for the child, too: some 10 MB are the least that can be seen.
    return {"stdout": stdout, "wall": seconds, "user": usage.ru_utime, "memory": usage.ru_maxrss / 1024}


def medians(runs):
    return {what: statistics.median(run[what] for run in runs) for what in ("wall", "user", "memory")}


def rounds(repeat, commands):
    """{name: its runs} for {name: function that runs once}: each round runs all of them, so that what else the machine does hits
    all of them alike."""
    results = {name: [] for name in commands}
    for number in range(repeat):
        for name, command in commands.items():
            print(f"run: round {number + 1} of {repeat}: {name}", file=sys.stderr)
            results[name].append(command())
    return results
