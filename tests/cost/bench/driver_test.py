"""The benchmarks' driver, on a made-up benchmark and one small job: driver_test.py FOLDER, that of the programs."""
import contextlib
import io
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
from driver import child, goals, google, jobs, micro, scaling  # noqa: E402
from driver.effort import Effort  # noqa: E402

BIN = Path(sys.argv.pop(1)).resolve()
RUN = Path(__file__).resolve().parent / "run"


def timed(name, *nanoseconds, operations=10):
    return [{"run_name": name, "family_index": 0, "run_type": "iteration", "time_unit": "ns", "cpu_time": time, "operations": operations}
            for time in nanoseconds]


def google_program(folder, benchmarks):
    """A program that prints what Google Benchmark would."""
    (folder / "results.json").write_text(json.dumps({"benchmarks": benchmarks}))
    program = folder / "program"
    program.write_text(f"#!/bin/sh\ncat '{folder}/results.json'\n")
    program.chmod(0o755)
    return program


class Driver(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def test_medians_of_one_operation(self):
        aggregate = {"run_name": "operation/+/double", "family_index": 0, "run_type": "aggregate", "cpu_time": 1, "operations": 1}
        program = google_program(self.folder, [aggregate, *timed("operation/+/double", 10, 50, 20), *timed("operation///double", 70)])
        found = google.run(program, 3, 0.01)
        self.assertEqual(found["+", "double"]["ns"], 2)
        self.assertEqual(found["/", "double"]["ns"], 7)

    def test_bounces_are_ratios_to_the_plain_one_of_the_same_group(self):
        benchmarks = []
        for group, factor in (("q=1", 1), ("q=2", 100)):
            for method, time in ((micro.PLAIN, 100), (micro.AFRESH, 200), ("Interval, one-sided", 300), ("Interval, two-sided", 700),
                                 ("Arb, one-sided", 3000), ("Arb, two-sided", 1000)):
                benchmarks += timed(f"bounce/{group}/{method}", time * factor)
        google_program(self.folder, benchmarks).rename(self.folder / "bench_bounce")
        with contextlib.redirect_stdout(io.StringIO()):
            _, found = micro.bounce(self.folder, Effort.QUICK)
        by_name = {goal.what: goal for goal in found}
        self.assertEqual([(goal.measured, goal.met) for goal in found[:2]], [(1.5, True), (1.5, True)])
        self.assertEqual(by_name["fastest peer over Interval, one-sided"].measured, 10)

    def test_goals_say_what_they_are(self):
        self.assertEqual(str(goals.Goal("a", 0.2, 0.15)), "a: goal at most 0.2, here 0.15: met")
        self.assertEqual(str(goals.Goal("a", 2, 2.5, " s")), "a: goal at most 2 s, here 2.5 s: NOT MET")
        self.assertEqual(str(goals.Goal("a", 0.85, 0.9, at_least=True)), "a: goal at least 0.85, here 0.9: met")
        self.assertEqual(str(goals.Goal("a", 1, None)), "a: goal at most 1, not measured here")

    def test_a_program_that_fails_is_an_error_with_its_reason(self):
        with self.assertRaisesRegex(RuntimeError, "exit code 2 of(?s:.*)is not a number"):
            child.once([BIN / "dumbbell", "certify", "zero"])

    def test_a_job_with_its_certificate(self):
        job = jobs.measure(BIN, ["certify 10"], 2)["certify 10"]
        self.assertGreater(job["boxes"], 0)
        self.assertGreater(job["bytes"], 0)
        self.assertGreater(job["verify"]["wall"], 0)
        self.assertTrue(1 < job["prove"]["memory"] < jobs.MEMORY_MB)

    def test_every_threaded_job_takes_jobs(self):
        for job in scaling.THREADED:
            words = job.split()
            self.assertIn("--jobs", child.once([BIN / "dumbbell", words[0], "--help"])["stdout"], job)

    def test_the_command(self):
        def run(*words):
            return subprocess.run([RUN, *words], capture_output=True, text=True, env=dict(os.environ, DUMBBELL_BIN=str(BIN)))

        self.assertEqual(run("--help").returncode, 0)
        self.assertEqual(run("--only", "nothing").returncode, 2)
        self.assertEqual(run("--repeat", "0").returncode, 2)
        self.assertEqual(run("--job", "certify 10").returncode, 2)
        out = self.folder / "sub" / "out.json"
        done = run("--only", "jobs", "--job", "certify 10", "--repeat", "1", "--out", str(out))
        self.assertEqual((done.returncode, [one["job"] for one in json.loads(out.read_text())["jobs"]]), (0, ["certify 10"]), done.stderr)


if __name__ == "__main__":
    unittest.main()
