"""The benchmarks' driver, on a made-up benchmark and one small job: driver_test.py FOLDER, that of the programs."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
from driver import child, goals, google, jobs, precision, published, scaling  # noqa: E402

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

    def test_the_least_time_of_one_operation(self):
        aggregate = {"run_name": "operation/+/double", "family_index": 0, "run_type": "aggregate", "cpu_time": 1, "operations": 1}
        program = google_program(self.folder, [aggregate, *timed("operation/+/double", 20, 10, 50), *timed("operation///double", 70)])
        found = google.run(program, 3, 0.01)
        self.assertEqual(found, {("+", "double"): 1, ("/", "double"): 7})

    def test_what_jobs_decide_is_read_from_what_they_print(self):
        runner = jobs.Runner(BIN, self.folder)

        def of(group, command, words):
            return [row[2:4] + row[5:] for row in precision.measure(runner, group, command, words, words, 1)]

        self.assertEqual(of("far", "certify", "1e6"), [("prove", "1e6", "N = 887"), ("verify", "1e6", "N = 887")])
        self.assertEqual(of("law", "law --ratio", "1e24"), [("prove", "1e24", "N = 8.86e+11")])
        share, checked = of("gap", "certify 1:10 --gap", "1e-4")
        self.assertEqual(share[2], checked[2])
        self.assertTrue(0 < float(share[2]) < 1e-3)
        self.assertLess(float(of("digits", "critical 5:7 --digits", "30")[0][2]), 1e-29)
        self.assertTrue(0 < float(of("boxes", "trace 10 --incoming --subdivide --shares --max-boxes", "200")[0][2]) < 1)
        below, above = precision.next_to_steps(runner, ["12"])
        self.assertEqual([of("hard", "certify", words)[0][2] for _, words in (below, above)], ["N = 11", "N = 12"])

    def test_a_page_gets_its_tables_and_keeps_the_rest(self):
        rows = [dict(zip(published.FIELDS, row)) for row in (("far", "certify", "prove", "1e6", "0.01", "N = 887"), ("far", "certify", "verify", "1e6", "0.02", "N = 887"))]
        page = "a\n<!-- table: jobs -->old<!-- end -->\nb\n"
        filled = published.with_tables(page, rows)
        self.assertIn("| `certify` | 1e6 | 0.01 | 0.02 | N = 887 |", filled)
        self.assertNotIn("old", filled)
        self.assertEqual((filled[:2], filled[-3:]), ("a\n", "\nb\n"))
        self.assertEqual(published.with_tables(filled, rows), filled)

    def test_the_digest_is_of_code_not_of_comments(self):
        for part in published.MEASURED:
            path = self.folder / part
            (path.parent if path.suffix else path).mkdir(parents=True, exist_ok=True)
            (path if path.suffix else path / "a.cpp").touch()
        source = self.folder / "src/number/a.hpp"
        source.write_text("int a;\n")
        before = published.digest(self.folder)
        source.write_text("int  a;  // a comment\n")
        self.assertEqual(published.digest(self.folder), before)
        source.write_text("int b;\n")
        self.assertNotEqual(published.digest(self.folder), before)

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
        self.assertEqual(run("--only", "precision", "--shortest", "--tsv", str(self.folder / "data")).returncode, 2)
        out = self.folder / "sub" / "out.json"
        done = run("--only", "jobs", "--job", "certify 10", "--repeat", "1", "--out", str(out))
        self.assertEqual((done.returncode, [one["job"] for one in json.loads(out.read_text())["jobs"]]), (0, ["certify 10"]), done.stderr)


if __name__ == "__main__":
    unittest.main()
