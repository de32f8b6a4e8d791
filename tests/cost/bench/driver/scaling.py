"""How the time of whole jobs grows: with the number of collisions, with the width of the gaps, with threads."""
import json
import math
import tempfile

from driver import child, tables
from driver.effort import Effort
from driver.goals import Goal
from driver.jobs import Runner

RATIOS = ["1e2", "1e4", "1e6", "1e8", "1e10", "1e12"]
GAPS = ["1e-3", "1e-6", "1e-12", "1e-24", "1e-48"]
# Over two seconds on two cores, or nearly.
THREADED = ["certify 1e60", "certify 1:1000000 --gap 1e-9", "certify 100 --section plain", "adiabatic --delta 0.01"]
LEAST_EFFICIENCY = 0.85
LONG_SECONDS = 2


def scaling(bin_folder, effort, repeat):
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(bin_folder, folder)
        collisions = with_collisions(runner, RATIOS[:effort.of(2, 4, None)], repeat)
        gaps = with_gaps(runner, GAPS[:effort.of(1, 3, None)], repeat)
        threads, goals = with_threads(runner, repeat) if effort is Effort.WHOLE else ([], [])
    return {"collisions": collisions, "gaps": gaps, "threads": threads}, goals


def with_collisions(runner, ratios, repeat):
    runs = child.rounds(repeat, {q: lambda q=q: runner.prove(f"certify {q}") for q in ratios})
    results, rows = [], []
    for q, of_q in runs.items():
        n = json.loads(of_q[0]["stdout"])["pieces"][0]["lower"]
        user = child.medians(of_q)["user"]
        before = results[-1] if results else None
        growth = math.log(user / before["user"]) / math.log(n / before["n"]) if before and before["user"] > 0.02 else None
        results.append({"ratio": q, "n": n, "user": user, "exponent": growth})
        rows.append([q, str(n), tables.time(user), f"{1e6 * user / n:.2f} us", tables.ratio(growth)])
    tables.show("Certify one ratio: with the number N of collisions", ["ratio", "N", "user", "user/N", "exponent"], rows,
                ["exponent e: user time grows like N^e from the line above (not said where starting the program is most of it)"])
    return results


def with_gaps(runner, gaps, repeat):
    runs = child.rounds(repeat, {gap: lambda gap=gap: runner.prove(f"certify 1:1000 --gap {gap}") for gap in gaps})
    results, rows = [], []
    for gap, of_gap in runs.items():
        user = child.medians(of_gap)["user"]
        digits = -math.log10(float(gap))
        pieces = json.loads(of_gap[0]["stdout"])["pieces"]
        bits = max(piece["bits"] for piece in pieces)
        results.append({"gap": gap, "user": user, "bits": bits, "pieces": len(pieces)})
        rows.append([gap, str(len(pieces)), str(bits), tables.time(user), f"{1e3 * user / digits:.1f} ms"])
    tables.show("Certify 1:1000: with the digits of --gap", ["gap", "pieces", "most bits", "user", "user/digit"], rows)
    return results


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
