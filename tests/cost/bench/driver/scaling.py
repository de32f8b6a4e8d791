"""How the time of whole jobs shrinks with threads."""
import tempfile

from driver import child, tables
from driver.effort import Effort
from driver.goals import Goal
from driver.jobs import Runner

# Over two seconds on two cores, or nearly.
THREADED = ["certify 1e60", "certify 1:1000000 --gap 1e-9", "certify 100 --section plain", "adiabatic --delta 0.01"]
LEAST_EFFICIENCY = 0.85
LONG_SECONDS = 2


def scaling(bin_folder, effort, repeat):
    if effort is not Effort.WHOLE:
        return [], []
    with tempfile.TemporaryDirectory() as folder:
        return with_threads(Runner(bin_folder, folder), repeat)


def with_threads(runner, repeat):
    parts = {"prove": runner.prove, "verify": runner.verify}
    commands = {f"{part} {job} --jobs {threads}": lambda run=run, job=job, threads=threads: run(job, "--jobs", str(threads))
                for job in THREADED for part, run in parts.items() for threads in (1, 2)}
    runs = child.rounds(repeat, commands)
    results, rows, goals = [], [], []
    for job in THREADED:
        for part in parts:
            one, two = (child.medians(runs[f"{part} {job} --jobs {threads}"]) for threads in (1, 2))
            efficiency = one["wall"] / (2 * two["wall"])
            results.append({"job": job, "part": part, "one": one, "two": two, "efficiency": efficiency})
            rows.append([f"{part} {job}", tables.time(one["wall"]), tables.time(two["wall"]), f"{efficiency:.2f}",
                         f"{two['user'] / one['user']:.2f}"])
            if one["wall"] > LONG_SECONDS:
                goals.append(Goal(f"parallel efficiency, {part} {job}", LEAST_EFFICIENCY, efficiency, at_least=True))
    tables.show("Threads: wall time with one and with two", ["job", "one", "two", "efficiency", "work"], rows,
                ["efficiency: T1/(2 T2); work: user time with two threads over that with one",
                 "A core that another program uses lowers the efficiency."])
    return results, goals
