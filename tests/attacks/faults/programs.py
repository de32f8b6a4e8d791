"""The two programs, run as a user runs them, with faults."""

import os
import resource
import signal
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

HANGS = 3000  # seconds: less than ctest waits, and more than anything takes on a busy machine


@dataclass
class Outcome:
    code: int  # negative: the signal that ended it
    out: str
    err: str

    @property
    def last_line(self) -> str:
        return self.out.rstrip("\n").rsplit("\n", 1)[-1]

    @property
    def loader_failed(self) -> bool:
        """The system could not even start the program."""
        return self.code == 127 and "shared libraries" in self.err


class Programs:
    def __init__(self, dumbbell: str, verify: str):
        self.dumbbell = str(dumbbell)
        self.verify = str(verify)

    def start(self, command, folder, memory_kib=None, user=None) -> subprocess.Popen:
        def prepare():
            if memory_kib is not None:
                resource.setrlimit(resource.RLIMIT_AS, (memory_kib * 1024, memory_kib * 1024))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            if user is not None:
                os.setgroups([])
                os.setgid(user)
                os.setuid(user)

        return subprocess.Popen([str(word) for word in command], cwd=folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=prepare)

    def run(self, command, folder, **limits) -> Outcome:
        return ended(self.start(command, folder, **limits))

    def run_killed(self, command, folder, moment, signal_number=signal.SIGKILL) -> Outcome:
        """`moment(process)` waits for the moment of the signal."""
        process = self.start(command, folder)
        moment(process)
        process.send_signal(signal_number)
        return ended(process)


def ended(process: subprocess.Popen) -> Outcome:
    try:
        out, err = process.communicate(timeout=HANGS)
    except subprocess.TimeoutExpired:
        process.kill()
        out, err = process.communicate()
        err += b"\nit hung"
    return Outcome(process.returncode, out.decode(errors="replace"), err.decode(errors="replace"))


def after(seconds: float):
    def moment(process):
        time.sleep(seconds)

    return moment


def once_there(path: Path, seconds: float):
    """As soon as the path exists, at the latest after this number of seconds."""

    def moment(process):
        end = time.monotonic() + seconds
        while not path.exists() and process.poll() is None and time.monotonic() < end:
            pass

    return moment
