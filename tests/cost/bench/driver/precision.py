"""Speed against error: the lines of docs/pictures/work-precision.tsv."""
import csv
import json
import tempfile
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

from driver import child, google, published, tables
from driver.effort import Effort
from driver.jobs import WITHOUT_CERTIFICATE, Runner

# Group, command, its settings; of each group the first is measured by --shortest.
JOBS = [("gap", "certify 1:10000 --gap", ["1e-3", "1e-6", "1e-9", "1e-12", "1e-15", "1e-48"]),
        ("range", "certify 1:1000000 --gap", ["1e-9"]),
        ("digits", "critical 3:102 --digits", ["10", "20", "50", "100", "200", "500"]),
        ("boxes", "trace 10 --incoming --subdivide --shares --max-boxes", ["500", "2000", "8000", "32000"]),
        ("law", "law --ratio", ["1e6", "1e12", "1e100", "1e1000"]),
        ("law", "law --prove", [""]),
        ("far", "certify", ["1e6", "1e8", "1e10", "1e12", "1e18", "1e24", "1e36", "1e50", "1e100"]),
        ("far", "certify --rho 1/2 --inertia", ["1e4", "1e6", "1e8"])]
HARD = ["1.000000000000001"]
STEPS, RELATIVE = ["12", "885598"], Fraction(1, 10**30)  # both sides of these steps, so near
MEMORY = Path("/dev/shm")
RUNS, LONG = 3, 1  # the median of so many runs; one of a job that takes longer, in seconds


def number(digits):
    return digits if len(digits) < 8 else f"{Decimal(digits):.2e}"


def decided(group, printed):
    """What a job's JSON proves: the undecided share, the greatest relative radius of a critical ratio, the maximum."""
    if group in ("gap", "range"):
        pieces = printed["pieces"]
        ends = [(Fraction(piece["lo"]), Fraction(piece["hi"])) for piece in pieces]
        undecided = sum(hi - lo for (lo, hi), piece in zip(ends, pieces) if piece["status"] != "exact")
        return f"{float(undecided / (ends[-1][1] - ends[0][0])):.1e}"
    if group == "digits":  # a decimal that may be too small for a double
        return f"{max(Decimal(one['radius']) / Decimal(one['lo']) for one in printed['ratios']):.1e}"
    if group == "boxes":
        return f"{float(Fraction(printed['parts']['undecided']['share'])):.1e}"
    if "c0" in printed:
        return f"all but {float(printed['c0']):.4f} q^(-1/4)"
    piece = printed["pieces"][0] if "pieces" in printed else printed
    least, most = number(str(piece["lower"])), number(str(piece["upper"]))
    return f"N = {least}" if least == most else f"N = {least} to {most}"


def next_to_steps(runner, steps):
    """(what it is, the ratio) on both sides of each step."""
    for n in steps:
        q = Fraction(json.loads(runner.prove(f"critical {n} --digits 50")["stdout"])["ratios"][0]["q_c"])
        for sign, side in ((-1, "below"), (1, "above")):
            yield f"1e-30 {side} q_c({n})", f"{round(q * (1 + sign * RELATIVE) * 10**50)}/1{'0' * 50}"


def timed(run, runs):
    """The median of the CPU seconds, and what the first run printed."""
    done = [run()]
    while len(done) < runs and done[0]["cpu"] < LONG:
        done.append(run())
    return child.medians(done)["cpu"], done[0]["stdout"]


def measure(runner, group, command, setting, words, runs):
    job = f"{command} {words}".strip()
    one = () if command == "law --ratio" else ("--jobs", "1")  # which has one thread anyway
    seconds, printed = timed(lambda: runner.prove(job, *one), runs)
    result = decided(group, json.loads(printed))
    yield group, command, "prove", setting or "-", f"{seconds:.3f}", result
    if not job.startswith(WITHOUT_CERTIFICATE):
        seconds, _ = timed(lambda: runner.verify(job, "--jobs", "1"), runs)
        yield group, command, "verify", setting or "-", f"{seconds:.3f}", result


def whole_jobs(bin_folder, effort):
    runs = effort.of(1, 1, RUNS)
    # In memory: what a disk takes is not the program's.
    with tempfile.TemporaryDirectory(dir=MEMORY if MEMORY.is_dir() else None) as folder:
        runner = Runner(bin_folder, folder)
        for group, command, settings in JOBS:
            for setting in settings[:effort.of(1, 3, None)]:
                if setting or effort is Effort.WHOLE:
                    yield from measure(runner, group, command, setting, setting, runs)
        for setting, words in [*((q, q) for q in HARD), *next_to_steps(runner, STEPS[:effort.of(1, 1, None)])]:
            yield from measure(runner, "hard", "certify", setting, words, runs)


def operations(bin_folder, effort):
    """Over double; of double itself the nanoseconds."""
    results = google.run(bin_folder / "bench_operations", effort.of(1, 3, 9), effort.of(0, 0.01, 0.01))
    for (operation, method), ns in results.items():
        yield "operation", operation, method, "-", f"{ns / results[operation, 'double']:.3g}", f"{ns:.2g} ns"


def precision(bin_folder, effort, tsv):
    orbits = child.once([bin_folder / "bench_orbits", *effort.of(["--shortest"], [], [])])["stdout"]
    rows = [*csv.reader(orbits.splitlines(), delimiter="\t"), *operations(bin_folder, effort), *whole_jobs(bin_folder, effort)]
    if tsv:
        published.write(tsv, rows)
    tables.show("Speed against error", published.FIELDS, [list(row) for row in rows],
                ["Costs: of orbits and operations over plain double, of jobs CPU seconds with one thread."])
    return [dict(zip(published.FIELDS, row)) for row in rows], []
