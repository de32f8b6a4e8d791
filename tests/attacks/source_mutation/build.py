"""One build of a copy of the source that holds all mutants."""
import collections
import os
import re
import shutil
import subprocess
import sys

from mutants import HEADER, find, instrumented, read


def say(text):
    print(text, file=sys.stderr, flush=True)


def copy_of_source(root, work):
    """A fresh copy, the files with their times: what is not mutated need not be compiled again."""
    tree = work / "tree"
    shutil.rmtree(tree, ignore_errors=True)
    shutil.copytree(root, tree, ignore=shutil.ignore_patterns(".git", "build", "__pycache__"))
    return tree


def collect(group, tree):
    """(file, Mutant) of all files of the group."""
    arguments = ["-std=c++20", f"-I{tree / 'src'}", "-I/usr/include/eigen3", "-DDUMBBELL_VERSION=\"0\""]
    result = []
    for file, unit in group.files.items():
        mutants = find(str(tree / "src" / file), arguments, str(tree / "src" / unit), group.left_out,
                       file in group.texts)
        result += [(file, mutant) for mutant in mutants]
    return result


def write(tree, numbered, originals):
    by_file = collections.defaultdict(list)
    for number, (file, mutant) in numbered.items():
        by_file[file].append((number, mutant))
    for file, source in originals.items():
        text = f'#include "{tree / "dm.hpp"}"\n' + instrumented(source, by_file[file])
        path = tree / "src" / file
        if not path.exists() or read(path) != text:
            path.write_text(text, encoding="latin-1")


def culprits(output, folder, numbered):
    """The mutants that the compiler's errors are about: those that a message names, or else the last one
    before its place."""
    found = set()
    for file, line, column, message in re.findall(r"([^\s:]+/src/[\w/.]+):(\d+):(\d+): error(.*)", output):
        named = re.findall(r"Chosen::operator==\((\d+)\)", message) if "could not convert" in message else []
        found.update(int(number) for number in named)
        path = folder / file
        if named or not path.exists():
            continue
        text = read(path)
        offset = sum(len(x) + 1 for x in text.split("\n")[:int(line) - 1]) + int(column)
        before = [m for m in re.finditer(r"dm::active [!=]= (\d+)", text) if m.start() < offset + 6]
        if before:
            found.add(int(before[-1].group(1)))
    return found & set(numbered)


def build(group, tree, folder, numbered, originals, jobs):
    """Builds; leaves out of `numbered` the mutants that are no C++. Returns how many these are."""
    (tree / "dm.hpp").write_text(HEADER, encoding="ascii")
    dropped = 0
    configure = ["cmake", "-S", tree, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=OFF",
                 "-DCMAKE_CXX_FLAGS_RELEASE=-O1", "-DBUILD_TESTING=ON",
                 "-DCMAKE_CXX_FLAGS=-w -fmax-errors=0"]
    environment = dict(os.environ, CCACHE_BASEDIR=str(tree.parent), CCACHE_NOHASHDIR="1")
    if shutil.which("ccache"):  # what is not mutated is compiled once, whatever the folder
        configure.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    while True:
        write(tree, numbered, originals)
        done = subprocess.run(["cmake", "--build", folder, "-j", str(jobs), "--target", *group.targets,
                               "--", "-k", "0"], capture_output=True, text=True, env=environment)
        if done.returncode == 0:
            return dropped
        wrong = culprits(done.stdout + done.stderr, folder, numbered)
        if not wrong:
            raise SystemExit("the mutated source does not compile:\n" + done.stdout[-6000:])
        dropped += len(wrong)
        say(f"  {len(wrong)} mutants are no C++ ({dropped} so far)")
        for number in wrong:
            del numbered[number]
