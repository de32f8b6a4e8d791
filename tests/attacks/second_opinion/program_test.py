#!/usr/bin/env python3
"""program_test.py VERIFIER: the second verifier as a program, run from its folder: what it prints, its exit codes, and what no
file and no command line can make of it. (Changed certificates: mutants_test.py.)"""

import ast
import gzip
import os
import pty
import resource
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import second
from second import body, signed

import options

VERIFIER = sys.argv.pop()
CERTIFICATES = second.PROJECT / "certificates"
STAIRS = str(CERTIFICATES / "stairs-1-100.dbc")
Q10 = str(CERTIFICATES / "q-10.dbc")


def run(words, program=(sys.executable, second.FOLDER), **more):
    """Exit code, output and errors."""
    more = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "check": False, **more}
    ended = subprocess.run([*program, *words], **more)
    return ended.returncode, (ended.stdout or b"").decode(), (ended.stderr or b"").decode()


def first(words, **more):
    return run(words, (VERIFIER,), **more)


class Files(unittest.TestCase):
    def verdict(self, text, words=()):
        """The line of the second verifier for a file with these bytes; the first one says the same, but for the reason."""
        with tempfile.NamedTemporaryFile() as file:
            file.write(text)
            file.flush()
            line, code = second.verdict_line(file.name, words)
            expected = first(["--quiet", *words, file.name])
        self.assertEqual(code, expected[0], line)
        self.assertEqual(line.split(" ")[:2], expected[1].split(" ")[:2])
        if code == 1:  # of damaged compressed files each reads what it can
            at = 3 if "code=gzip" in line else 2
            self.assertEqual(line.split(" ")[at:4], expected[1].split(" ")[at:4])
        return line

    def test_every_count_of_a_cover_of_all_states(self):
        """With one collision less in all leaves, some leaf does not hold."""
        for name in ("full-100.dbc.gz", "full-plain-10.dbc.gz"):
            lines = body(CERTIFICATES / name)
            less = [f"count {max(0, int(line[6:]) - 1)}" if line.startswith("count ") else line for line in lines]
            self.assertIn("code=count not certified", self.verdict(signed(less)))
            self.assertIn("not certified", self.verdict(signed(["split eta" if line == "split e" else line for line in lines])))
            self.assertIn("code=split", self.verdict(signed(["split q" if line == "split e" else line for line in lines])))

    def test_totals_checksum_and_end(self):
        lines = body(Q10)
        self.assertIn("line=19 code=total", self.verdict(signed([line.replace("total count 2", "total count 3") for line in lines])))
        whole = signed(lines)
        packed = gzip.compress(whole)
        for text, found in ((whole.replace(b"upper 4", b"upper 5"), "line=26 code=sha256"), (whole + b"\n", "line=26 code=trailing"),
                            (whole[:-1], "line=26 code=truncated"), (whole.replace(b"\n", b"\r\n"), "line=1 code=encoding"),
                            (b"\xef\xbb\xbf" + whole, "line=1 code=encoding"), (whole.decode().encode("utf-16"), "line=1 code=encoding"),
                            (b"", "line=1 code=truncated"), (b"\x00" * 5000, "line=1 code=byte"), (b"a" * 5000, "line=1 code=line"),
                            (b"README\n", "not a certificate, whose first line is `dumbbell-certificate 1`"),
                            (packed + packed, "code=gzip"), (packed + b"x", "code=gzip"), (packed[:-9], "code=gzip"),
                            (packed[:100] + b"\xff" * 20 + packed[120:], "code=gzip"), (packed[:2], "line=1 code=gzip")):
            self.assertIn(found, self.verdict(text))
        self.assertIn("s VERIFIED ", self.verdict(packed))

    def test_a_start_beside_a_corner(self):
        """It has two collisions, where the tangent of the floor leads from the first one to a ray that misses by a hair."""
        lines = body(second.PROJECT / "tests/attacks/false_claims/starts-beside-corner.dbc")
        with tempfile.NamedTemporaryFile() as file:
            for number, code in (("1", 1), ("2", 0)):
                Path(file.name).write_bytes(signed([line.replace("n 1 1", f"n {number} {number}").replace("y 1 h", f"y {number} h") for line in lines]))
                self.assertEqual(second.verdict_line(file.name)[1], code)

    def test_unsupported(self):
        lines = body(Q10)
        for old, new in (("dumbbell-certificate 1", "dumbbell-certificate 2"), ("lemmas 1", "lemmas 2"),
                         ("lemmas 1", "lemmas minimal"), ("scene dumbbell", "scene moon"), ("section turning", "section none"),
                         ("claim collisions", "claim heavy"), ("claim collisions", "claim initial-conditions"),
                         ("claim collisions", "claim incoming")):
            self.assertIn("s UNSUPPORTED line=", self.verdict(signed([line.replace(old, new) for line in lines])))

    def test_claims(self):
        """What proves less than is demanded is rejected, in the words of the first verifier."""
        for words in (["--max", "9"], ["--min", "3"], ["--exactly", "10"], ["--ratio", "1:101", "--max", "10"], ["--ratio=1/101"],
                      ["--ratio", "1:101"], ["--ratio", "99:100", "--max", "9"], ["--ratio", "99:100", "--exactly", "10"],
                      ["--ratio", "0.01:0.1", "--max", "10"], ["--ratio", "1e2", "--exactly", "10"], ["--ratio", "10^2", "--max", "9"],
                      ["--ratio", "5:30"], ["--scene", "body"], ["--claim", "incoming"], ["--claim", "law", "--scene", "dumbbell"],
                      ["--claim", "collisions", "--scene", "dumbbell", "--ratio", "2", "--max", "3", "--min", "0"], ["--gap", "1e-6"],
                      ["--ratio", "5:11", "--gap", "0", "--max", "5"], ["--ratio", "5:12", "--gap", "0"], ["--heavy-at-most", "1"],
                      ["--coin"], ["--ratio", "10", "--gap", "0"], ["--gaps", "8"], ["--gaps", "7", "--gap", "0.01"]):
            line, code = second.verdict_line(STAIRS, words)
            self.assertEqual((code, line + "\n"), first(["--quiet", *words, STAIRS])[:2])
        self.assertEqual(first(["--max", "16", str(CERTIFICATES / "coin.dbc")])[1].splitlines()[-1],
                         second.verdict_line(CERTIFICATES / "coin.dbc", ["--max", "16"])[0])

    def test_where_nothing_is_proved(self):
        """The file is right all the same; a bound that is demanded is not proved."""
        lines = body(Q10)
        at, last = lines.index("upper 4"), lines.index("total split 0")
        totals = ["total " + word + " 0" for word in "split count outside meets meets-reversed equal-masses witness".split()]
        text = signed([*lines[:at], "upper none", "lower 0", *totals, "total open 1"])
        self.assertIn("s OPEN scene=dumbbell ", self.verdict(text))
        self.assertIn("s OPEN scene=dumbbell ", self.verdict(text, ["--ratio", "10"]))
        self.assertIn("code=claim-not-proved", self.verdict(text, ["--max", "1000"]))
        self.assertIn("code=claim-not-proved", self.verdict(text, ["--min", "1"]))

    def test_numbers_without_end(self):
        """Python refuses to read or write numbers of more than 4300 digits: here none gets so long."""
        lines, long = body(Q10), "1" * 2101
        for old, new in (("upper 4", f"upper {long}"), ("upper 4", f"upper {long[1:]}"), ("lower 4", f"lower {long[1:]}"),
                         ("pieces 1", f"pieces {long}"), ("ratio 10/1 10/1", f"ratio {long[1:]}/1 {long[1:]}/1"), ("bits 53", f"bits {long}")):
            self.verdict(signed([new if line == old else line for line in lines]))


class Program(unittest.TestCase):
    def test_command_lines(self):
        """The same output and exit code as the first verifier's: of right ones and of wrong ones."""
        for words in ([STAIRS, Q10], ["--quiet", STAIRS, Q10], ["--max", "9", STAIRS, Q10], ["/nowhere", Q10], ["--ratio", "x", Q10],
                      ["--max", "3x", Q10], ["--max", "-1", Q10], ["--max", "9" * 2101, Q10], ["--max", Q10, "--max", "4"], ["--min"],
                      ["--exactly", "4", "--max", "4", Q10], ["--ratio", "1:1e1001", Q10], ["--ratio", "3:2", Q10], ["--ratio", "1/2:2", Q10],
                      ["--scene", "moon", Q10], ["--scene", "body", "--max", "4", Q10], ["--quiet", "--rho", "1", Q10],
                      ["--scene", "body", "--rho", "2", Q10], ["--quiet", "--scene", "body", "--rho", "1/2:1", Q10], ["--ratio", "1/0", Q10], ["--surely", Q10], [], ["--quiet", "--", "--quiet"], ["-q", Q10],
                      ["--quiet", str(CERTIFICATES)], ["--quiet", "no\nthing", "no\x1b[31mthing"], ["--max=4", "--", Q10, Q10],
                      ["--ratio", "", Q10], ["--quiet", ""], ["--coin", "--ratio", "4", Q10], ["--claims", "/nowhere"], ["--claims", Q10, Q10],
                      ["--claims", Q10, "--max", "4"],
                      ["--quiet", "--ratio", "7" * 990 + "e999", "--rod-mass", "3" * 990 + "e-999", "--max", "5", str(CERTIFICATES / "coin.dbc")]):
            ours, theirs = run(words), first(words)
            self.assertEqual(ours[:2], theirs[:2], words)
            self.assertEqual(ours[2].replace(options.NAME, "dumbbell-verify"), theirs[2], words)

    def test_lists(self):
        """The same verdicts as the first verifier's."""
        coin = str(CERTIFICATES / "coin.dbc")
        with tempfile.NamedTemporaryFile("w", suffix=".tsv") as rows:
            rows.write(f"{Q10}\t--ratio 10 --exactly 4\tremark\n{STAIRS}\t--ratio 1:100 --max 10 --gap 1e-7\n{coin}\t--coin --max 4\n")
            rows.flush()
            self.assertEqual(run(["--claims", rows.name])[:2], first(["--claims", rows.name])[:2])
            rows.seek(0)
            rows.truncate()
            rows.write("q-10.dbc\t--ratio 10 --exactly 4\n")
            rows.flush()
            for name in ("-", "/dev/stdin", "/dev/fd/0"):  # which have no folder
                with open(rows.name, "rb") as list_file:
                    self.assertEqual(run(["--claims", name], stdin=list_file, cwd=CERTIFICATES)[0], 0)

    def test_it_runs_as_it_is_and_optimized_and_packed(self):
        """From the folder, with -O, isolated, and packed, it prints the same; the packed file has the same bytes each time."""
        with tempfile.TemporaryDirectory() as folder:
            packed, again = Path(folder) / "dumbbell-verify.pyz", Path(folder) / "again.pyz"
            for file in packed, again:
                subprocess.run([sys.executable, second.FOLDER / "pack.py", file], check=True)
            self.assertEqual(packed.read_bytes(), again.read_bytes())
            self.assertLess(packed.stat().st_size, 52_000)
            false_claims = second.PROJECT / "tests/attacks/false_claims"
            words = [STAIRS, str(CERTIFICATES / "full-100.dbc.gz"), str(CERTIFICATES / "law.dbc.gz"),
                     *sorted(str(path) for path in false_claims.glob("less-deep-*.dbc"))]
            expected = run(words)
            self.assertEqual([expected[1].count(word) for word in ("s VERIFIED", "s REJECTED")], [2, len(words) - 3])
            for program in ([sys.executable, "-OO", second.FOLDER], [sys.executable, "-I", packed], [packed]):
                self.assertEqual(run(words, program, cwd=folder), expected)
            self.assertEqual(sorted(os.listdir(folder)), ["again.pyz", "dumbbell-verify.pyz"])

    def test_help_and_version(self):
        self.assertEqual(run(["--help"]), (0, options.HELP, ""))
        version = first(["--version"])[1].split(" ")[1]
        self.assertEqual(run(["--version", Q10]), (0, f"{options.NAME} {version}\n", ""))
        self.assertLessEqual(max(map(len, options.HELP.splitlines())), 120)

    def test_standard_input(self):
        with open(CERTIFICATES / "full-100.dbc.gz", "rb") as file:
            self.assertEqual(run(["-"], stdin=file)[:2], (0, second.verdict_line(CERTIFICATES / "full-100.dbc.gz")[0] + "\n"))
        self.assertEqual(run(["-"], preexec_fn=lambda: os.close(0)), (2, "s UNREADABLE Bad file descriptor\n", ""))
        with tempfile.TemporaryDirectory() as folder:
            os.mkfifo(f"{folder}/pipe")
            self.assertEqual(run([f"{folder}/pipe"])[1], first(["--quiet", f"{folder}/pipe"])[1])

    def test_output_that_does_not_arrive(self):
        said = (2, "", f"{options.NAME}: cannot write to the standard output\n")
        with open("/dev/full", "wb") as full:
            self.assertEqual(run([Q10], stdout=full), said)
            self.assertEqual(run(["--help"], stdout=full), said)
            self.assertEqual(run(["--surely"], stderr=full)[0], 2)
        self.assertEqual(run([Q10], preexec_fn=lambda: os.close(1)), said)
        self.assertEqual(run(["--surely"], preexec_fn=lambda: os.close(2))[0], 2)
        read, write = os.pipe()
        os.close(read)
        self.assertEqual(run([Q10], stdout=write, preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_DFL)),
                         (-signal.SIGPIPE, "", ""))
        os.close(write)

    def test_a_budget_ends_it(self):
        """Work is counted in steps, so it ends in the same line again."""
        words = ["--budget", "0.1s", str(CERTIFICATES / "stairs-1-1e4.dbc.gz")]
        code, line, _ = run(words)
        self.assertRegex(line, r"^s LIMIT line=[1-9]\d\d+ more work than the budget of 0.1 s: --budget allows more\n$")
        self.assertEqual((code, run(words)), (4, (4, line, "")))
        self.assertEqual(run(["--budget=0s", Q10])[0], 4)
        # All its leaves are refused at two precisions, and the third has 9,000 bits.
        precise = Path(__file__).with_name("many-bits.dbc.gz")
        self.assertEqual([run(["--budget", time, precise])[0] for time in ("0.3s", "1s")], [4, 0])
        for time in ("", "s", "10", "10d", "-1s", "1/2s"):
            self.assertEqual(run(["--budget", time, Q10])[0], 2)

    def test_it_ends_without_memory(self):
        """Too little to start is no case of its own: Python itself may need more."""
        with tempfile.NamedTemporaryFile() as file:
            file.write(gzip.compress(b"a" * (120 << 20)))
            file.flush()
            least = lambda: resource.setrlimit(resource.RLIMIT_AS, (100 << 20, 100 << 20))
            self.assertEqual(run([file.name], preexec_fn=least), (4, "s LIMIT out of memory\n", ""))
            self.assertEqual(run([file.name])[:2], (1, "s REJECTED line=1 code=line more than 4096 bytes: not a certificate, "
                                                       "whose first line is `dumbbell-certificate 1`\n"))

    def test_progress_on_a_terminal_and_an_interrupt(self):
        """On a terminal a line tells the share that was read; Ctrl-C ends the program, and nothing is said to be verified."""
        ours, theirs = pty.openpty()
        slow = subprocess.Popen([sys.executable, second.FOLDER, CERTIFICATES / "stairs-1-1e6.dbc.gz"], stdout=subprocess.PIPE, stderr=theirs)
        os.close(theirs)
        self.assertRegex(os.read(ours, 100), rb"^\rverifying:  +[0-9]+ % of the lines$")
        slow.send_signal(signal.SIGINT)
        self.assertEqual((slow.communicate()[0], slow.returncode), (b"", -signal.SIGINT))
        os.close(ours)


class Source(unittest.TestCase):
    def test_python_3_8_and_no_assertion(self):
        """All of it is written for Python 3.8, and no check is an assertion, which `python3 -O` leaves out."""
        for file in second.FOLDER.glob("*.py"):
            tree = ast.parse(file.read_text(), file.name, feature_version=(3, 8))
            self.assertFalse([node.lineno for node in ast.walk(tree) if isinstance(node, ast.Assert)], file.name)


if __name__ == "__main__":
    unittest.main()
