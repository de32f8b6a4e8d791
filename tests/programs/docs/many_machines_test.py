#!/usr/bin/env python3
"""many_machines_test.py PAGE BIN: runs the recipes of the page as they are printed, with the programs of the folder BIN in
the PATH, and disturbs them. Whatever happens, the parts and what `join` makes of them have the same bytes."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PAGE, BIN = pathlib.Path(sys.argv[1]).read_text(), pathlib.Path(sys.argv[2]).resolve()
PARTS = [f"part-{k}.dbc" for k in range(1, 9)]
PARALLEL, SLURM = re.findall(r"^```sh\n(.*?)^```$", PAGE, re.M | re.S)
ONE_BY_ONE = re.search(r"^\$ (for .*)$", PAGE, re.M).group(1)
JOIN = re.search(r"^\$ (dumbbell join .*)$", PAGE, re.M).group(1)
VERIFY = re.search(r"^\$ (dumbbell-verify .*)$", PAGE, re.M).group(1)
MOST_SECONDS = 600  # of anything, on a machine that is very busy


class Folder:
    """A folder to work in."""

    def __init__(self, path):
        self.path = pathlib.Path(path)

    def run(self, commands, first=None):
        path = ":".join([*([str(first)] if first else []), str(BIN), os.environ["PATH"]])
        process = subprocess.run(["bash", "-c", commands], cwd=self.path, env=dict(os.environ, PATH=path),
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


class Recipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        whole = cls.folder("undisturbed")
        assert whole.run(ONE_BY_ONE)[0] == 0
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

    def test_a_slurm_array(self):
        folder = self.folder("slurm")
        sbatch = folder.program("sbatch", """\
range=$(sed -n 's/^#SBATCH --array=//p' "$1")
for k in $(seq "${range%-*}" "${range#*-}"); do SLURM_ARRAY_TASK_ID=$k sh "$1" || exit; done
""")
        code, said = folder.run(SLURM, sbatch)
        self.assertEqual(code, 0, said)
        self.check_joined(folder)

    def test_gnu_parallel(self):
        folder = self.folder("parallel")
        code, said = folder.run(PARALLEL)
        self.assertEqual(code, 0, said)
        (folder.path / "part-3.dbc").unlink()
        self.assertIn("missing", folder.run(JOIN)[1])
        self.assertEqual(folder.run("sed -i '/part-3.dbc/d' parallel.log\n" + PARALLEL)[0], 0)
        self.check_joined(folder)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
