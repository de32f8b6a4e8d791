"""What is published of the measurements: docs/pictures/work-precision.tsv, and the picture and the tables that are made from it."""
import csv
import hashlib
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[4]
TSV = ROOT / "docs/pictures/work-precision.tsv"
PICTURE = ROOT / "docs/pictures/work-precision.svg"
PAGE = ROOT / "docs/7-speed.md"
COMMAND = "./run bench --only precision --tsv docs/pictures/work-precision.tsv"
FIELDS = ["group", "case", "method", "setting", "cost", "result"]
MEASURED = ["src/number", "src/flight", "src/collisions", "src/critical", "src/wings/starts", "src/wings/law",
            *(f"src/verify/{room}" for room in ("core", "machine", "guess", "functions", "macro", "sections", "wings/starts", "wings/law")),
            "tests/cost/bench", "tests/cost/bench/driver/precision.py",
            *(f"tests/rooms/flight/{name}.hpp" for name in ("hard_orbits", "propagation", "wall_step"))]
FORMS = [("monotone", "two rays"), ("mean value", "mean value steps"), ("parallelepiped", "parallelepiped"),
         ("natural", "plain intervals"), ("correlated", "mean value of the whole orbit")]


def digest(root=ROOT):
    """SHA-256 of the sources measured. Comments and layout do not count."""
    found = hashlib.sha256()
    for part in MEASURED:
        for path in sorted((root / part).rglob("*.?pp")) or [root / part]:
            code = re.sub(rb"//[^\n]*", b"", path.read_bytes()).split()
            found.update(str(path.relative_to(root)).encode() + b"\n" + b" ".join(code) + b"\n")
    return found.hexdigest()


def write(tsv, rows):
    """Of the shipped file the picture and the page are made again, too."""
    lines = [f"# SHA-256 of the sources measured: {digest()}", *("\t".join(row) for row in [FIELDS, *rows])]
    tsv.write_text("\n".join(lines) + "\n")
    if tsv.resolve() == TSV:
        PICTURE.write_text(drawn())
        PAGE.write_text(with_tables(PAGE.read_text(), read()))


def digest_of_shipped():
    return TSV.read_text().splitlines()[0].split(": ")[1]


def read():
    return list(csv.DictReader(TSV.read_text().splitlines()[1:], delimiter="\t"))


def drawn():
    return subprocess.run([PICTURE.with_name("work-precision-picture")], stdout=subprocess.PIPE, text=True, check=True).stdout


def lines(head, rows):
    return "\n".join(f"| {' | '.join(row)} |" for row in [head, ["---"] * len(head), *rows])


def unique(rows, *fields):
    return list(dict.fromkeys(tuple(row[field] for field in fields) for row in rows))


def orbits(rows):
    cases = [case for case, in unique(rows, "case")]
    by = {(row["method"], row["setting"], row["case"]): row for row in rows}
    return lines(["arithmetic", "bits", *(f"{case}: {what}" for case in cases for what in ("cost", "width"))],
                 [[*key, *(by[*key, case][what] for case in cases for what in ("cost", "result"))]
                  for key in unique(rows, "method", "setting")])


def forms(rows):
    def cell(case, form):
        return ", ".join(row["result"].split(" of ")[0] for row in rows if (row["case"], row["method"]) == (case, form))

    return lines(["orbit", "its collisions", *(name for _, name in FORMS)],
                 [[case, next(row["result"].split(" of ")[1] for row in rows if row["case"] == case),
                   *(cell(case, form) for form, _ in FORMS)] for case, in unique(rows, "case")])


def operations(rows):
    methods = [method for method, in unique(rows, "method")]
    by = {(row["case"], row["method"]): row["result"] for row in rows}
    return lines(["", *methods], [[case, *(by.get((case, method), "") for method in methods)] for case, in unique(rows, "case")])


def jobs(rows):
    by = {(row["case"], row["setting"], row["method"]): row["cost"] for row in rows}
    return lines(["`dumbbell` ...", "", "CPU s", "verifier", "result"],
                 [[f"`{case}`", setting, by[case, setting, "prove"], by.get((case, setting, "verify"), ""), result]
                  for case, setting, result in unique(rows, "case", "setting", "result")])


TABLES = {"orbits": (orbits, ("orbit",)), "forms": (forms, ("form",)), "operations": (operations, ("operation",)),
          "jobs": (jobs, ("gap", "range", "digits", "boxes", "law", "far", "hard"))}


def with_tables(page, rows):
    """The page with each table as the rows have it."""
    def table(found):
        make, groups = TABLES[found[2]]
        return f"{found[1]}\n\n{make([row for row in rows if row['group'] in groups])}\n\n{found[3]}"

    return re.sub(r"(<!-- table: (\w+) -->).*?(<!-- end -->)", table, page, flags=re.DOTALL)
