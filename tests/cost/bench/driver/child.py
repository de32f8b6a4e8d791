"""Runs a program of the project, and measures it."""
import os
import statistics
import subprocess
import sys
import tempfile
import time


def once(command):
    """One run: stdout, seconds of wall and of CPU time (user; with that of the kernel), peak memory in MB."""
    begin = time.monotonic()
    # Peak memory by a small program between: what a process occupied before exec counts for it, too, and this one is large.
    with tempfile.TemporaryFile("w+") as errors, tempfile.NamedTemporaryFile("r") as peak:
        command = ["/usr/bin/time", "-f", "%M", "-o", peak.name, *command]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, text=True) as process:
            stdout = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.monotonic() - begin
        errors.seek(0)
        if process.returncode != 0:
            raise RuntimeError(f"exit code {process.returncode} of: {' '.join(map(str, command[5:]))}\n{errors.read().strip()}")
        return {"stdout": stdout, "wall": seconds, "user": usage.ru_utime,
                "cpu": usage.ru_utime + usage.ru_stime, "memory": int(peak.read()) / 1024}


def medians(runs):
    return {what: statistics.median(run[what] for run in runs) for what in ("wall", "user", "cpu", "memory")}


def rounds(repeat, commands):
    """{name: its runs} for {name: function that runs once}: each round runs all of them, so that what else the machine does hits
    all of them alike."""
    results = {name: [] for name in commands}
    for number in range(repeat):
        print(f"run: round {number + 1} of {repeat}, {len(commands)} jobs", file=sys.stderr)
        for name, command in commands.items():
            results[name].append(command())
    return results
