#!/usr/bin/env python3
"""many_machines_test.py PAGE BIN: runs the recipes of the page as they are printed, with the programs of the folder BIN in
the PATH, and disturbs them. Whatever happens, the parts and what `join` makes of them have the same bytes."""

import contextlib
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PAGE, BIN = pathlib.Path(sys.argv[1]).read_text(), pathlib.Path(sys.argv[2]).resolve()
PARTS = [f"part-{k}.dbc" for k in range(1, 9)]
JOIN = re.search(r"^\$ (dumbbell join .*)$", PAGE, re.M).group(1)
VERIFY = re.search(r"^\$ (dumbbell-verify .*)$", PAGE, re.M).group(1)
MOST_SECONDS = 600  # of anything, on a machine that is very busy


def recipe(heading, number=0):
    """The shell commands under a heading: its first block, or a later one."""
    section = PAGE.split(f"\n## {heading}\n", 1)[1].split("\n## ", 1)[0]
    return re.findall(r"^```sh\n(.*?)^```$", section, re.M | re.S)[number]


MAKEFILE, MAKE = recipe("GNU make"), recipe("GNU make", 1)
MAKEFLOW, WORKER = recipe("Makeflow"), recipe("Makeflow", 1)


def environment(folder, first):
    """Debian's makeflow starts MPI, which does not run for root unless told twice. A killed worker leaves its workspace."""
    path = f"{BIN}:{os.environ['PATH']}"
    return dict(os.environ, PATH=f"{first}:{path}" if first else path, TMPDIR=str(folder), OMPI_ALLOW_RUN_AS_ROOT="1",
                OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def wait_for(condition):
    end = time.monotonic() + MOST_SECONDS
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError
        time.sleep(0.002)


class Folder:
    """A folder to work in."""

    def __init__(self, path):
        self.path = pathlib.Path(path)

    def start(self, commands, first=None):
        """In a session of its own, so that all of it can be killed."""
        with (self.path / "log").open("ab") as log:
            return subprocess.Popen(["bash", "-c", commands], cwd=self.path, env=environment(self.path, first),
                                    start_new_session=True, stdin=subprocess.DEVNULL, stdout=log, stderr=log)

    def run(self, commands, first=None):
        process = subprocess.run(["bash", "-c", commands], cwd=self.path, env=environment(self.path, first),
                                 timeout=MOST_SECONDS, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True, check=False)
        return process.returncode, process.stdout

    def parts(self):
        return {name: (self.path / name).read_bytes() for name in PARTS if (self.path / name).exists()}

    def program(self, name, text):
        """A shell script of this name in a folder of its own, for the PATH."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.path))
        (folder / name).write_text(f"#!/bin/sh\n{text}")
        (folder / name).chmod(0o755)
        return folder


def kill(process):
    with contextlib.suppress(ProcessLookupError):  # it has ended
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


class Recipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        whole = cls.folder("undisturbed")
        assert whole.run(MAKEFILE + MAKE)[0] == 0
        cls.undisturbed = whole.parts()
        code, said = whole.run(f"{JOIN} && {VERIFY}")
        assert code == 0 and "s VERIFIED " in said, said
        cls.joined = (whole.path / "stairs.dbc").read_bytes()

    @classmethod
    def folder(cls, name):
        path = pathlib.Path(cls.scratch.name) / name
        path.mkdir()
        return Folder(path)

    def check_joined(self, folder):
        self.assertEqual(folder.parts(), self.undisturbed)
        code, said = folder.run(JOIN)
        self.assertEqual(code, 0, said)
        self.assertEqual((folder.path / "stairs.dbc").read_bytes(), self.joined)

    def test_make_that_is_killed_goes_on(self):
        folder = self.folder("make")
        self.assertEqual(folder.run(MAKEFILE)[0], 0)
        while True:  # until it is killed in the middle
            process = folder.start(MAKE)
            wait_for(lambda: process.poll() is not None or folder.parts() and any(folder.path.glob("part-*.partial")))
            kill(process)
            if len(folder.parts()) < len(PARTS):
                break
            for name in PARTS:
                (folder.path / name).unlink()
        code, said = folder.run(JOIN)
        self.assertNotEqual(code, 0, said)
        self.assertEqual(folder.run(MAKE)[0], 0)
        self.check_joined(folder)

    def test_makeflow_with_a_worker_that_is_killed_and_one_that_lies(self):
        folder = self.folder("makeflow")
        self.assertEqual(folder.run(MAKEFILE)[0], 0)
        works = folder.path / "works"  # the process that does so
        lazy = folder.program("dumbbell", f"echo $$ > {works}.new\nmv {works}.new {works}\nexec sleep 3600\n")
        liar = folder.program("dumbbell", 'case "$*" in *part-5.dbc*) echo nonsense > part-5.dbc ;; *) exec '
                                          f'{BIN}/dumbbell "$@" ;; esac\n')
        with contextlib.ExitStack() as started:
            def start(commands, first=None):
                process = folder.start(commands, first)
                started.callback(kill, process)
                return process

            makeflow = start(MAKEFLOW)
            wait_for(lambda: (folder.path / "port").exists() and (folder.path / "port").read_text().strip())
            killed = start(WORKER, lazy)
            wait_for(works.exists)
            start(WORKER, liar)
            kill(killed)
            with contextlib.suppress(ProcessLookupError):  # the worker gave its command a process group of its own
                os.kill(int(works.read_text()), signal.SIGKILL)
            self.assertEqual(makeflow.wait(MOST_SECONDS), 0)
        self.assertEqual([name for name in PARTS if folder.parts().get(name) != self.undisturbed[name]], ["part-5.dbc"])
        code, said = folder.run(JOIN)
        self.assertNotEqual(code, 0)
        self.assertIn("part-5.dbc", said)
        self.assertFalse((folder.path / "stairs.dbc").exists())
        again = re.search(r"dumbbell certify .* --out \S+", said).group()
        self.assertEqual(folder.run(re.sub(r"\S+$", "part-5.dbc", again))[0], 0)
        self.check_joined(folder)

    def test_a_slurm_array(self):
        folder = self.folder("slurm")
        sbatch = folder.program("sbatch", """\
range=$(sed -n 's/^#SBATCH --array=//p' "$1")
for k in $(seq "${range%-*}" "${range#*-}"); do SLURM_ARRAY_TASK_ID=$k sh "$1" || exit; done
""")
        code, said = folder.run(recipe("A Slurm array"), sbatch)
        self.assertEqual(code, 0, said)
        self.check_joined(folder)

    def test_gnu_parallel(self):
        folder = self.folder("parallel")
        code, said = folder.run(recipe("GNU parallel"))
        self.assertEqual(code, 0, said)
        (folder.path / "part-3.dbc").unlink()
        self.assertIn("missing", folder.run(JOIN)[1])
        self.assertEqual(folder.run("sed -i '/part-3.dbc/d' parallel.log\n" + recipe("GNU parallel"))[0], 0)
        self.check_joined(folder)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
