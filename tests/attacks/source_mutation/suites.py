"""The tests, one by one: which mutants each comes by, how long it takes, and whether it notices one."""
import os
import re
import signal
import subprocess
import time
from dataclasses import dataclass

MEMORY = 6 << 30    # bytes of a test's process
BATCH_SECONDS = 1   # test cases of one program that take no longer together share a process


@dataclass(frozen=True)
class Test:
    name: str
    command: tuple
    case: str       # of a Catch2 program; empty: `command` is the whole test
    seconds: float
    reached: bytes  # a byte for each mutant


def list_tests(group, folder, places):
    """(name, command, case) of all tests of a group. `places` are the folders that its commands name."""
    for command in group.replays:
        filled = tuple(word.format(**places) for word in command)
        yield " ".join([filled[0].rsplit("/", 1)[-1], *filled[1:]]), filled, ""
    for program in group.programs:
        path = str(folder / program)
        listed = subprocess.run([path, "--list-test-names-only"], capture_output=True, text=True, check=False)
        for case in listed.stdout.splitlines():
            if case:
                yield f"{program.rsplit('/', 1)[-1]}: {case}", (path, "--abort"), case


def with_cases(command, cases):
    """Of a Catch2 program only these cases."""
    if not cases[0]:
        return list(command)
    return [*command, "--warn", "NoTests", ",".join(re.sub(r"([\\,\[])", r"\\\1", case) for case in cases)]


def run(command, environment, seconds):
    """True: passed, False: failed, None: it took too long. `seconds` is what it usually takes. Time is the
    processor's, so that a busy machine kills no mutant; nobody waits for ever, all the same."""
    limited = ["prlimit", f"--cpu={int(5 * seconds + 3)}", f"--as={MEMORY}", "--core=0", "--", *command]
    process = subprocess.Popen(limited, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        code = process.wait(30 * seconds + 30)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return None
    return None if code in (-signal.SIGXCPU, -signal.SIGKILL) else code == 0


def measured(group, folder, places, mutants):
    """Runs every test of the group once, without a mutant."""
    path = str(places["work"] / "reached")
    tests = []
    for name, command, case in list_tests(group, folder, places):
        with open(path, "wb") as file:
            file.write(bytes(mutants + 1))
        environment = dict(os.environ, DUMBBELL_REACHED=path, DUMBBELL_TEST_SCALE="1", TMPDIR=str(places["tmp"]))
        start = time.monotonic()
        if not run(with_cases(command, [case]), environment, 600):
            raise SystemExit(f"fails without any mutant: {name}")
        seconds = time.monotonic() - start
        with open(path, "rb") as file:
            tests.append(Test(name, command, case, seconds, file.read()))
    if not tests:
        raise SystemExit("no tests")
    return sorted(tests, key=lambda test: test.seconds)


def batches(tests, number):
    """The tests that come by a mutant, the quickest first, in lists that one process runs."""
    batch, total = [], 0
    for test in tests:
        if not test.reached[number]:
            continue
        fits = batch and test.case and test.command == batch[0].command and total + test.seconds <= BATCH_SECONDS
        if batch and not fits:
            yield batch
            batch, total = [], 0
        batch.append(test)
        total += test.seconds
    if batch:
        yield batch


def noticed(tests, number, places, scale=1):
    """(what noticed the mutant, the seconds that it took): "" if nothing did, although tests come by it,
    None if none does. `scale`: how much the tests try."""
    start = time.monotonic()
    environment = dict(os.environ, DUMBBELL_MUTANT=str(number), DUMBBELL_TEST_SCALE=str(scale), TMPDIR=str(places["tmp"]))
    by = None
    for batch in batches(tests, number):
        command = with_cases(batch[0].command, [test.case for test in batch])
        passed = run(command, environment, scale * sum(test.seconds for test in batch))
        if not passed:
            program = os.path.basename(batch[0].command[0])
            return ("time" if passed is None else program), time.monotonic() - start
        by = ""
    return by, time.monotonic() - start
