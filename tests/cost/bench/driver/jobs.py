"""Whole jobs: a command of the program, and the verification of the certificate that it writes."""
import json
import os
import shlex
import tempfile
from pathlib import Path

from driver import child, tables
from driver.effort import Effort
from driver.goals import Goal

# The table of docs/5-results.md, then the other commands.
CERTIFY = ["1", "1.0000001", "1.1", "4.6", "4.61", "10", "12", "100", "1000", "1e4", "1e6", "1:100 --gap 1e-6", "1e9",
           "1:10000 --gap 1e-9", "1:10000 --gap 1e-12", "100 --section full", "1000 --section full"]
OTHERS = ["critical 3:22", "trace 10 --phi 0.3:0.4 --phidot 1 --y 3 --ydot 0 --subdivide",
          "adiabatic --theorem lemma3.1 --delta 0.1"]
# Only of the whole.
SLOW = ["certify 1e12", "certify 1:1000000 --gap 1e-9", "certify 10000 --section full", "certify 100 --section plain",
        "critical 3:100 --digits 200", "adiabatic --delta 0.01"]
WITHOUT_CERTIFICATE = ("critical", "law --ratio")

MEMORY_MB = 200
# Job, greatest seconds of proving and of verifying.
TIME_GOALS = [("certify 1:10000 --gap 1e-9", 2, 5), ("certify 1e12", 20, None)]


def all_jobs(effort):
    return [f"certify {words}" for words in CERTIFY] + OTHERS + (SLOW if effort is Effort.WHOLE else [])


def boxes(printed):
    """The boxes that a command's JSON reports, or None."""
    if printed["schema"] == "dumbbell-certify-1":
        return sum(piece["leaves"] for piece in printed["pieces"])
    if printed["schema"] == "dumbbell-adiabatic-1":
        return sum(result["leaves"] for result in printed["results"])
    if printed["schema"] == "dumbbell-trace-1" and printed["parts"]:
        return sum(part["boxes"] for part in printed["parts"]["exact"]) + printed["parts"]["undecided"]["boxes"]
    return None


class Runner:
    def __init__(self, bin_folder, folder):
        self.prover, self.verifier, self.folder = bin_folder / "dumbbell", bin_folder / "dumbbell-verify", Path(folder)

    def certificate(self, job):
        return self.folder / (job.replace(" ", "_").replace("/", "_") + ".dbc")

    def prove(self, job, *more):
        words = shlex.split(job)
        out = [] if job.startswith(WITHOUT_CERTIFICATE) else ["--out", self.certificate(job)]
        return child.once([self.prover, *words, *more, *out, "--json"])

    def verify(self, job, *more):
        return child.once([self.verifier, *more, self.certificate(job)])


def measure(bin_folder, jobs, repeat):
    """For each job the medians of proving and of verifying, its boxes, and the size of its certificate."""
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(bin_folder, folder)

        def pair(job):
            proved = runner.prove(job)
            return proved, runner.verify(job) if runner.certificate(job).exists() else None

        runs = child.rounds(repeat, {job: lambda job=job: pair(job) for job in jobs})
        results = {}
        for job, pairs in runs.items():
            certificate = runner.certificate(job)
            results[job] = {
                "prove": child.medians([proved for proved, _ in pairs]),
                "verify": child.medians([verified for _, verified in pairs]) if certificate.exists() else None,
                "bytes": os.path.getsize(certificate) if certificate.exists() else None,
                "boxes": boxes(json.loads(pairs[0][0]["stdout"]))}
    return results


def jobs(bin_folder, wanted, effort, repeat):
    results = measure(bin_folder, wanted or all_jobs(effort), repeat)
    rows = []
    for job, one in results.items():
        prove, verify = one["prove"], one["verify"] or {}
        rows.append([job, tables.time(prove["wall"]), tables.time(prove["user"]), tables.memory(prove["memory"]),
                     "-" if one["boxes"] is None else f"{one['boxes']:,}",
                     tables.rate(one["boxes"] and one["boxes"] / max(prove["user"], 1e-3)),
                     tables.time(verify.get("wall")), tables.time(verify.get("user")), tables.memory(verify.get("memory")),
                     "-" if one["bytes"] is None else f"{one['bytes']:,}"])
    tables.show(f"Whole jobs, starting the program included: medians of {repeat}",
                ["job", "wall", "user", "memory", "boxes", "boxes/s", "verify", "user", "memory", "bytes"], rows,
                ["boxes/s: boxes of the certificate for each second of user time, witnesses and all else included; a box stands",
                 "for the orbits followed from it. The program does not report how many bounces it followed: no bounces/s here."])
    return [{"job": job, **one} for job, one in results.items()], goals(results)


def goals(results):
    found = []
    for job, prove, verify in TIME_GOALS:
        if job in results:
            found.append(Goal(job, prove, results[job]["prove"]["wall"], " s"))
            if verify:
                found.append(Goal(f"verification of {job}", verify, results[job]["verify"]["wall"], " s"))
    most = max((part["memory"], job) for job, one in results.items() for part in (one["prove"], one["verify"]) if part)
    found.append(Goal(f"memory, at its greatest ({most[1]})", MEMORY_MB, most[0], " MB"))
    return found
