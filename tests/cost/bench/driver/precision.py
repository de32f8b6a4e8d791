"""Work and precision: the data of docs/pictures/work-precision.svg, as TSV."""
import csv
import io
import json
import tempfile
from fractions import Fraction

from driver import child, tables
from driver.jobs import Runner

FIELDS = ["diagram", "case", "bits", "form", "bounces", "of", "error_x", "error_slope", "cost_us"]
GAPS = [3, 6, 9, 12, 18, 24, 36, 48]
DIGITS = [10, 20, 50, 100, 150, 200]
RANGE = "1:100"
CRITICAL = "10"


def orbits(bin_folder, effort):
    """The enclosure of x and of the slope kappa/r, from a point, after the last collision that is certified; cost of a collision."""
    printed = child.once([bin_folder / "bench_stability", *effort.of(["--shortest"], [], [])])["stdout"]
    for row in csv.DictReader(io.StringIO(printed), delimiter="\t"):
        if row["start"] == "point":
            yield {"diagram": "orbit", "case": row["orbit"], "bits": row["bits"], "form": row["form"],
                   "bounces": row["collisions"], "of": row["of"], "error_x": row["x last"], "error_slope": row["slope last"],
                   "cost_us": row["us/collision"]}


def gaps(runner, some, repeat):
    """The share of the range that is left undecided, against --gap."""
    runs = child.rounds(repeat, {n: lambda n=n: runner.prove(f"certify {RANGE} --gap 1e-{n}") for n in some})
    for n, of_n in runs.items():
        pieces = json.loads(of_n[0]["stdout"])["pieces"]
        low, high = map(Fraction, RANGE.split(":"))
        open_width = sum(Fraction(piece["hi"]) - Fraction(piece["lo"]) for piece in pieces if piece["status"] != "exact")
        yield {"diagram": "gap", "case": RANGE, "bits": max(piece["bits"] for piece in pieces), "form": f"--gap 1e-{n}",
               "bounces": "-", "of": "-", "error_x": f"{float(open_width / (high - low)):.1e}", "error_slope": "-",
               "cost_us": f"{1e6 * child.medians(of_n)['user']:.0f}"}


def digits(runner, some, repeat):
    """The radius of a critical ratio, against --digits."""
    runs = child.rounds(repeat, {n: lambda n=n: runner.prove(f"critical {CRITICAL} --digits {n}") for n in some})
    for n, of_n in runs.items():
        critical = json.loads(of_n[0]["stdout"])["ratios"][0]
        # The radius is a decimal that may be too small for a double: its power of ten says enough.
        yield {"diagram": "digits", "case": f"q_c({CRITICAL})", "bits": critical["bits"], "form": f"--digits {n}", "bounces": "-",
               "of": "-", "error_x": critical["radius"], "error_slope": "-",
               "cost_us": f"{1e6 * child.medians(of_n)['user']:.0f}"}


def precision(bin_folder, effort, repeat, tsv):
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(bin_folder, folder)
        rows = [*orbits(bin_folder, effort), *gaps(runner, GAPS[:effort.of(1, None, None)], repeat),
                *digits(runner, DIGITS[:effort.of(1, None, None)], repeat)]
    text = io.StringIO()
    writer = csv.DictWriter(text, FIELDS, delimiter="\t", lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    if tsv:
        tsv.write_text(text.getvalue())
    tables.show("Work and precision", FIELDS, [[str(row[field]) for field in FIELDS] for row in rows])
    return rows, []
