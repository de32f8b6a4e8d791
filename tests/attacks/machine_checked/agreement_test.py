#!/usr/bin/env python3
"""agreement_test.py PROJECT BUILD DUMBBELL DUMBBELL_VERIFY MUTATION: the checker extracted from the Coq proof and the project's verifier
have the same verdict on what both can judge, files with the sections turning and full of the scene dumbbell: on the shipped certificates, the
committed false claims, a sample of all mutants, and on certificates written now. Where the verifier says no, the proved checker must.
What it decides without a certificate is what `dumbbell certify` finds.

DUMBBELL_TEST_SCALE (1) times as many fresh certificates, claims, and mutants (up to ten times), and the largest shipped certificate. Two things are
done at a time, and the checker is given many files at once. It is built again in BUILD, of the present source; 77: `./run prove` has built none."""

import gzip
import hashlib
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import unittest
import zlib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
PROJECT = Path(sys.argv[1])
BUILD, DUMBBELL, VERIFIER, MUTATION = sys.argv[2:6]
PROVE = BUILD + "/program/prove"
if not os.path.exists(PROVE):
    sys.exit(77)
subprocess.run([PROJECT / "proofs/coq/prove", BUILD, "--build"], check=True)
del sys.argv[1:6]
SCALE = int(os.environ.get("DUMBBELL_TEST_SCALE", "1"))
BASES = ["equal", "single", "thousand", "single-split", "deep", "range", "range-from-1", "range-split", "range-deep", "open", "loose", "big",
         "big-range", "full", "full-equal", "full-range", "full-deep", "full-again"]
JUDGED = [[b"lemmas " + lemmas, b"scene dumbbell", b"section " + section]
          for lemmas, section in ((b"1", b"turning"), (b"1", b"full"), (b"minimal", b"full"))]
CODES = {"VERIFIED": 0, "REJECTED": 1, "UNREADABLE": 2, "UNSUPPORTED": 3, "LIMIT": 4, "OPEN": 3}
RIGHT = ("s VERIFIED ", "s OPEN ")
UNKNOWN = ("--coin", "--rho", "--inertia", "--scene", "--claim")  # to the proved checker


def verdict(options, path):
    """The verifier's exit code and last line."""
    ended = subprocess.run([VERIFIER, "--quiet", *options, path], capture_output=True, text=True, check=False)
    line = (ended.stdout.splitlines() or [ended.stderr])[-1]
    return ended.returncode, re.sub(" (widest-gap|not-demanded)=[^ ]*", "", line)  # which the proved checker does not say


def proved(options, paths):
    """The same of the proved checker, for each file."""
    ended = subprocess.run([PROVE, *options, "--", *paths, os.devnull], capture_output=True, text=True, check=False)
    if not ended.stdout:
        return [(ended.returncode, ended.stderr)] * len(paths)
    lines = [line.rsplit(" file=", 1) for line in ended.stdout.splitlines()]
    if [name for _, name in lines] != [*map(str, paths), os.devnull]:
        raise AssertionError(f"exit code {ended.returncode} behind {len(lines)} of {len(paths)} files: {ended.stderr}")
    return [(CODES[line.split()[1]], line) for line, _ in lines[:-1]]


def is_judged(path):
    data = path.read_bytes()
    try:
        data = gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
    except (OSError, EOFError, zlib.error):
        return True  # refused by both
    lines = data.split(b"\n")
    return lines[2:5] in JUDGED and lines[5:6] != [b"claim law"]


def manifest(path):
    for line in path.read_text().splitlines():
        if line and not line.startswith("#"):
            name, options, code = line.split("\t")[:3]
            yield path.parent / name, options.split(), int(code)


def sealed(lines):
    """The text of these lines, the last of which is to be the checksum."""
    text = "".join(line + "\n" for line in lines[:-1])
    return f"{text}sha256 {hashlib.sha256(text.encode()).hexdigest()}\n"


def tampered(lines, chance):
    """A certificate with one line of a tree, a bound or the ratios changed, and its checksum again right."""
    changes = {"count": lambda a: f"count {max(0, int(a) + chance.choice([-1, -1, -1, 1]))}",
               "split": lambda a: f"split {chance.choice([axis for axis in ('e', 't', 'eta', 'q') if axis != a])}",
               "upper": lambda a: f"upper {int(a) - 1}", "lower": lambda a: f"lower {int(a) + 1}"}
    places = [k for k, line in enumerate(lines) if line.split()[0] in changes]
    common = [k for k in places if lines[k].split()[0] in ("count", "split")]
    place = chance.choice(common if chance.random() < 0.9 else places)
    word, *rest = lines[place].split()
    return sealed([*lines[:place], changes[word](*rest), *lines[place + 1:]])


class Agreement(unittest.TestCase):
    def same(self, options, paths, theirs):
        """Their verdicts on the files, and ours, of which a yes is to be a yes, and nothing else."""
        ours = proved(options, paths)
        for path, their, our in zip(paths, theirs, ours):
            if their[0] == 0 or (their[0] == 3 and "scene=" in their[1]):
                self.assertTrue(our[1].startswith(RIGHT), f"{path} {options}: {our[1]}, but the verifier accepts it")
            else:
                self.assertFalse(our[1].startswith(RIGHT), f"{path} {options}: {our[1]}, but the verifier has exit code {their[0]}")
        return ours

    def test_shipped(self):
        tried = 0
        for row in (PROJECT / "certificates/claims.tsv").read_text().splitlines():
            name, claim, _, small = row.split("\t")
            path = PROJECT / "certificates" / name
            if name.startswith("#") or not is_judged(path) or (small != "yes" and SCALE == 1):
                continue
            theirs = verdict(claim.split(), path)
            self.assertEqual(self.same(claim.split(), [path], [theirs]), [theirs])
            tried += 1
        self.assertGreater(tried, 5)

    def refused(self, table):
        """How many files of the table were refused and accepted."""
        numbers = [0, 0]
        alike = {}
        for path, options, code in manifest(table):
            if is_judged(path) and not any(option.startswith(UNKNOWN) for option in options):
                alike.setdefault(tuple(options), []).append((path, (code, "")))
                numbers[code == 0] += 1
        for options, files in alike.items():
            for k in range(0, len(files), 200):
                self.same(options, *zip(*files[k:k + 200]))
        return numbers

    def test_false_claims(self):
        refused, _ = self.refused(PROJECT / "tests/attacks/false_claims/manifest.tsv")
        self.assertGreater(refused, 40)

    def mutants(self, base):
        with tempfile.TemporaryDirectory() as folder:
            corpus = Path(folder) / "corpus"
            subprocess.run([MUTATION, "--jobs", "1", "--base", base, "--most", str(400 * min(SCALE, 10)), "--dump", corpus, str(40 * min(SCALE, 10))],
                           check=True, capture_output=True)
            return self.refused(corpus / "manifest.tsv")

    def test_mutants(self):
        with ThreadPoolExecutor(2) as pool:
            numbers = list(pool.map(self.mutants, BASES))
        for base, (refused, accepted) in zip(BASES, numbers):
            print(f"{base}: {refused} refused, {accepted} accepted by both")
        self.assertGreater(sum(refused for refused, _ in numbers), 200)

    def test_plain_mutants(self):
        """The mutants above have no certificate with `lemmas minimal`."""
        chance = random.Random(16)
        lines = gzip.decompress((PROJECT / "certificates/full-plain-10.dbc.gz").read_bytes()).decode().splitlines()
        with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
            paths = [Path(folder) / f"{k}.dbc" for k in range(30 * SCALE)]
            for path in paths:
                path.write_text(tampered(lines, chance))
            theirs = list(pool.map(lambda path: verdict([], path), paths))
            ours = pool.map(lambda k: self.same([], paths[k:k + 30], theirs[k:k + 30]), range(0, len(paths), 30))
            refused = sum(code != 0 for part in ours for code, _ in part)
        self.assertGreater(refused, 20)

    def fresh(self, folder, requests):
        """Certificates that are written now, by these options of `dumbbell certify`: both accept them, and say the same."""
        paths = []
        for k, request in enumerate(requests):
            path = Path(folder) / f"{k}.dbc"
            written = subprocess.run([DUMBBELL, "certify", *request, "--out", path], capture_output=True, text=True, check=False)
            self.assertIn(written.returncode, (0, 3), written.stderr)
            if path.exists():
                paths.append(path)
        theirs = [verdict([], path) for path in paths]
        self.assertEqual(self.same([], paths, theirs), theirs)
        gaps = ["--gap", "1e-6", "--gaps", "1"]
        self.same(gaps, paths, [verdict(gaps, path) for path in paths])
        return len(paths)

    def test_fresh(self):
        chance = random.Random(4)
        # The first two are just below and above a step, where doubles with less care do not decide; the last has a witness of 160 bits.
        requests = [["4.60333884875166266"], ["62.713703004982352372"], ["510.7718505372994119506"]]
        for _ in range(20 * SCALE):
            low = round(10 ** chance.uniform(0, 4), chance.randrange(6))
            # Single ratios, narrow ranges, and ratios next to a step, which take more than 53 bits.
            request = chance.choice([[str(low)], [f"{low}:{low * (1 + 10 ** chance.uniform(-6, -1)):.9f}"], ["4.603338848751701"],
                                     [f"{4.603338848751 + chance.uniform(0, 1e-11):.17f}"],
                                     [f"{1 + chance.uniform(0, 100):.3f}", "--section", "full"],
                                     [f"{1 + chance.uniform(0, 6):.3f}", "--section", "plain"]])
            requests.append(request)
        parts = [requests[k:k + 20] for k in range(0, len(requests), 20)]
        with ThreadPoolExecutor(2) as pool, tempfile.TemporaryDirectory() as folder:
            folders = [tempfile.mkdtemp(dir=folder) for _ in parts]
            self.assertGreater(sum(pool.map(self.fresh, folders, parts)), 15 * SCALE)

    def test_far(self):
        """Counts beyond a million are too many for the proved checker, with or without a witness; it does not say that they are wrong."""
        with tempfile.TemporaryDirectory() as folder:
            below, beyond, cover = (Path(folder) / name for name in ("below.dbc", "beyond.dbc", "cover.dbc"))
            for ratio, path in (("1e10", below), ("6e12", beyond)):
                subprocess.run([DUMBBELL, "certify", ratio, "--out", path], check=True, capture_output=True)
            text = re.sub("lower .*\nwitness .*\n", "lower 0\n", beyond.read_text()).replace("total witness 1", "total witness 0")
            cover.write_text(sealed(text.splitlines()))
            self.assertEqual([verdict([], path)[0] for path in (below, beyond, cover)], [0, 0, 0])
            self.assertEqual([code for code, _ in proved([], [below, beyond, cover])], [0, 4, 4])

    def decided(self, ratio, *claim):
        """The exit code without a file, which the line agrees with."""
        ended = subprocess.run([PROVE, "--ratio", ratio, *map(str, claim)], capture_output=True, text=True, check=False)
        self.assertEqual((ended.stdout or "s UNREADABLE ").split()[1], {0: "VERIFIED", 1: "REJECTED", 2: "UNREADABLE", 4: "LIMIT"}[ended.returncode])
        return ended.returncode

    def same_numbers(self, found):
        """One line of `dumbbell certify --json`: its bounds are theorems without a file; of a single ratio no better ones are."""
        ratio = found["given"]
        most, least = max(piece["upper"] for piece in found["pieces"]), min(piece["lower"] for piece in found["pieces"])
        self.assertEqual(self.decided(ratio, "--max", most, "--min", least), 0, found)
        # One that some motion attains, or that some ratio does not, cannot be made better.
        if most == max(piece["lower"] for piece in found["pieces"]):
            self.assertEqual(self.decided(ratio, "--max", most - 1), 1, found)
        if least == min(piece["upper"] for piece in found["pieces"]):
            self.assertEqual(self.decided(ratio, "--min", least + 1), 1, found)

    def test_orbits(self):
        chance = random.Random(50)
        # The ratios of test_fresh next to a step, and one 1e-40 above one; then any, and ranges.
        requests = ["4.60333884875166266", "62.713703004982352372", "510.7718505372994119506", "4.6033388487517003525565820291030165130674", "1"]
        for k in range(24 * SCALE):
            low = round(10 ** chance.uniform(0, 7 if k % 6 else 3), chance.randrange(6))
            requests.append(f"{low}" if k % 6 else f"{low}:{low * (1 + 10 ** chance.uniform(-6, -1)):.9f}")
        listed = subprocess.run([DUMBBELL, "certify", "--json", "--list", "-"], input="\n".join(requests), capture_output=True, text=True, check=True)
        found = [json.loads(line) for line in listed.stdout.splitlines()]
        self.assertEqual(len(found), len(requests))
        with ThreadPoolExecutor(2) as pool:
            list(pool.map(self.same_numbers, found))

    def test_law(self):
        """Where no orbit can be followed."""
        chance = random.Random(61)
        requests = [f"{chance.uniform(1, 10):.6f}e{chance.randrange(13, 300)}" for _ in range(20 * SCALE)]
        listed = subprocess.run([DUMBBELL, "law", "--json", "--list", "-"], input="\n".join(requests), capture_output=True, text=True, check=True)
        for found in map(json.loads, listed.stdout.splitlines()):
            self.same_numbers(found | {"pieces": [{side: int(found[side]) for side in ("upper", "lower")}]})

    def test_orbits_at_the_edge(self):
        """Equal masses, masses exchanged, ratios and numbers beyond all bounds, more collisions than the budget has, what is no claim."""
        for ratio, claim, code in (("1", "--exactly 2", 0), ("1", "--max 1", 1), ("1", "--min 3", 1), ("1.000000000000000000000001", "--min 3", 0),
                                   ("1/10", "--exactly 4", 0), ("1:1e6", "--max 887", 0), ("1:1e6", "--max 887 --min 3", 1),
                                   ("999900:1e6", "--exactly 887", 0), ("1e8", "--exactly 8857", 0), ("1e1000", "--min 5", 0),
                                   ("1e1000", "--max 5", 1), ("10", "--max " + "9" * 2100, 0), ("10", "--min " + "9" * 2100, 1),
                                   ("1e13", "--exactly 2800499", 0), ("1275056886695232788234520.2", "--min 1000000000000", 4),
                                   ("10", "--min 0", 0), ("10", "--max 0", 1), ("10", "", 2), ("2:1", "--max 5", 2), ("0", "--max 5", 2)):
            self.assertEqual(self.decided(ratio, *claim.split()), code, f"{ratio} {claim}")
        self.assertEqual(subprocess.run([PROVE, "--max", "5"], capture_output=True, check=False).returncode, 2)

    def test_beside(self):
        """What a file proves is said to be a theorem without it, too."""
        path = PROJECT / "certificates/stairs-1-100.dbc"
        for options, said in (([], "two orbits prove the same bounds"), (["--ratio", "10:20", "--max", "9"], "two orbits prove the same bounds")):
            ended = subprocess.run([PROVE, *options, path], capture_output=True, text=True, check=False)
            self.assertEqual((ended.returncode, said in ended.stderr), (0, True), ended)

    def test_hard_work(self):
        """Lines that are too long, trees that are too deep, and work that would take days are refused at once."""
        lines = (PROJECT / "certificates/q-100.dbc").read_text().splitlines()
        place = next(k for k, line in enumerate(lines) if line.startswith("count"))
        first, second = map(int, lines[place].split()[1:])
        slow = [re.sub("^bits .*", "bits 2048", line) for line in lines]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "hard.dbc"
            for changed, code in (([*lines[:place], "count " + "1" * 5000, *lines[place + 1:]], 1),
                                  ([*lines[:place], *["split e"] * 300000], 1),
                                  ([*slow[:place], f"count {first + 900000} {second}", *slow[place + 1:]], 4),
                                  ([*slow[:place], f"count {first - 1} {second}", *slow[place + 1:]], 1)):
                path.write_text(sealed([*changed, "sha256"]) if changed[-1] == "split e" else sealed(changed))
                self.assertEqual(proved([], [path])[0][0], code, changed[place][:60])

    def test_asked(self):
        """What is asked has the verifier's answer: counts of as many digits as it takes; gaps as they are, a little narrower, or one fewer."""
        nines = "9" * 2100
        for code, name, *asked in (
                (0, "q-10.dbc", f"--max {nines}", "--gap 0 --gaps 0"), (1, "q-10.dbc", f"--min {nines}", f"--exactly {nines}", "--heavy-at-most 1"),
                (2, "q-10.dbc", f"--max {nines}9", "--gap 1", "--gap x", "--gap 0/0", "--gap 1/0", "--gap -1/9"),
                (0, "stairs-1-100.dbc", "--gap 1e-6 --gaps 8", "--ratio 4.6033388:4.7 --gaps 1", "--ratio 1/11:1/10 --gap 0 --gaps 0"),
                (1, "stairs-1-100.dbc", "--gap 0.999999999e-6", "--gaps 7", "--gap 0", "--ratio 4.603338848751701 --gap 1/2")):
            path = PROJECT / "certificates" / name
            for options in map(str.split, asked):
                self.assertEqual([verdict(options, path)[0], proved(options, [path])[0][0]], [code, code], options)
        for option in UNKNOWN:
            self.assertIn(f"knows no {option}: leave it out", proved([option], ["any"])[0][1])


if __name__ == "__main__":
    unittest.main()
