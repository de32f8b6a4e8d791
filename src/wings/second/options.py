"""The command line: the claim, in the words of dumbbell-verify, and the files."""

from types import SimpleNamespace

from claim_list import read_claims
from claim_options import demand_of, take
from values import Usage, time

NAME = "dumbbell-verify.pyz"
VERSION = "0.1.0"
DEFAULT_BUDGET = 600  # seconds

HELP = f"""usage: {NAME} [options] FILE...
       {NAME} [options] --claims LIST
Checks certificates of the program dumbbell (docs/reference/format.md): every line, in interval arithmetic on whole
numbers. It shares no code with dumbbell-verify, the first verifier, and needs nothing but Python 3.8 or later.

  --ratio RATIO|LO:HI   the mass ratios (heavy/light) in question; default: those of the file
  --max N               demand the proof that no trajectory has more than N collisions
  --min N               demand the proof that some trajectory has at least N collisions
  --exactly N           both
  --gap REL             demand the proof of the greatest number itself, at every ratio in question but in gaps of at
                        most this relative width, where it is one of two neighbouring numbers (of bodies: two or three);
                        gaps that touch are one
  --gaps N              and that there are at most N of them
  --heavy-at-most 1     demand the proof that the heavy mass hits the floor at most once
  --inertia Q|LO:HI     the bodies in question: their Q = (d1/k)^2, in place of a mass ratio; and
  --rho RHO|LO:HI       their d2/d1, above 0 and at most 1
  --coin                the same as --rho 1 --inertia 4
  --rod-mass MU         with --ratio RATIO: the dumbbell whose rod has MU times the mass of its ends
  --phi, --phidot, --y, --ydot A|LO:HI
                        with --claim initial-conditions: the starts in question; default: the box of the file
  --decided SHARE       with --claim initial-conditions or incoming: demand the proof of the number of collisions on
                         this share of what is in question, from 0 to 1; of a rectangle of bodies: of those with
                         Q rho > 1, by area in (log rho, log Q)
  --scene dumbbell|body
                        demand this scene; default: what the other options state, dumbbell or body, else the file's
  --claim KIND          demand this kind of claim: collisions, initial-conditions or incoming; of kinds that it does not
                        judge it reads the options: --delta, --heights, --margin, --exponent, --constant, --attained
  --claims LIST         a list of certificates, each with its claim, such as certificates/claims.tsv. A line has a file
                        (its name is relative to the list's folder), a tab, and options above that state a whole claim
  --budget TIME         give up on a file that costs more work than a core does in about this time: 30s, 10m, 2h
                        (10m). Counted in steps, not by a clock
  --quiet               print the last line only, and show no progress
  -h, --help            print this help and end
  -V, --version         print the version and end

  {NAME} --ratio 10 --exactly 4 ten.dbc                     is N*(10) = 4 proved?
  {NAME} --ratio 1:100 --max 10 --gap 1e-6 stairs.dbc.gz    N* known on the whole range, but for hairs?
  {NAME} ten.dbc                                            what does this file prove?
  {NAME} --claim incoming --max 4 incoming.dbc              at most 4 from every incoming trajectory?
  {NAME} --ratio 3 --max 3 *.dbc                            which files prove this?

FILE `-` is the standard input; files may be packed with gzip. For one file the last line is the verdict: s VERIFIED,
s OPEN, s REJECTED, s UNSUPPORTED, s UNREADABLE or s LIMIT. What was demanded only in part has not-demanded= at its end:
a file that proves less there would pass, too. Each of several files has one such line with its name, and a line of
totals ends them. Exit codes: 0 verified and proved; 1 rejected; 2 usage or unreadable; 3 unsupported, or open (no claim
is stated, and no bound is proved for all that is in question); 4 resource limit. If files differ: the first of 1, 4, 3,
2, 0.

It does not judge the law for every mass ratio, nor the adiabatic invariant: such files are unsupported. It is
much slower than dumbbell-verify: minutes for a range up to 10^6.
"""


def parse(words):
    """Options are `--name VALUE` or `--name=VALUE`; after `--` there are none. Of what is returned `jobs` are the files, each with
    its demand. `answer`: print this text alone."""
    asked = SimpleNamespace(jobs=[], quiet=False, answer=None, budget=None)
    words, files, claim, others, ended = list(words), [], {}, {}, False
    while words:
        word = words.pop(0)
        if word == "--" and not ended:
            ended = True
        elif ended or word == "-" or not word.startswith("-"):
            files.append(word)
        elif word == "--quiet":
            asked.quiet = True
        elif word in ("-h", "--help"):
            asked.answer = HELP
        elif word in ("-V", "--version"):
            asked.answer = f"{NAME} {VERSION}\n"
        elif not (take(word, words, claim) or take(word, words, others, ("budget", "claims"))):
            raise Usage(f"unknown option {word}; see --help")
    if asked.answer is None:
        asked.budget = time("--budget", others["budget"]) if "budget" in others else DEFAULT_BUDGET
        asked.jobs = jobs(files, claim, others.get("claims"))
    return asked


def jobs(files, claim, claims):
    """Each file with its demand."""
    if claims is None:
        if not files:
            raise Usage("no FILE; see --help")
        demand = demand_of(claim)
        return [(path, demand) for path in files]
    if claim:
        raise Usage(f"--claims and --{next(iter(claim))} exclude each other; see --help")
    if files:
        raise Usage("--claims names the files: give no other FILE")
    return read_claims(claims)
