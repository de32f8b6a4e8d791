"""One campaign of a test: its folder, its managers, its workers, and whether it ended as it must."""

import json
import shlex
import subprocess
from pathlib import Path

import journal
from checks import check, wait_until
from host import Host

CLAIM = ["1:100000", "--gap", "1e-9"]


class Manager:
    """`dumbbell campaign run` on a host."""

    def __init__(self, words, host: Host, err: Path, out: Path):
        self.err = err
        self.out = out
        self.process = host.start(["sh", "-c", 'out=$1; shift; exec "$@" > "$out"', "sh", out, *words], err)

    def said(self) -> str:
        return self.err.read_text()

    def worker_words(self) -> list[str]:
        """The line that it prints to start a worker."""
        wait_until(lambda: "to start one: " in self.said() or self.process.poll() is not None, "the manager listens")
        lines = [line for line in self.said().splitlines() if "waiting for workers" in line]
        check(lines, f"the manager ended at once, with {self.process.returncode}: {self.said()!r}")
        return shlex.split(lines[0].split("to start one: ")[1])

    def ended(self) -> int:
        wait_until(lambda: self.process.poll() is not None, "the manager ends")
        return self.process.returncode


class Campaign:
    def __init__(self, place, name: str, shards: int):
        self.place = place
        self.folder = place.folder / name
        self.runs = 0
        planned = place.dumbbell("campaign", "plan", self.folder, *CLAIM, "--shards", str(shards))
        check(planned.returncode == 0, f"campaign plan: {planned.stderr}")

    def run(self, host: Host, *options: str, is_open: bool = True) -> Manager:
        """A manager on `host`; `is_open`: to the others."""
        self.runs += 1
        stem = f"{self.folder}-run-{self.runs}"
        address = ["--address", host.address] if is_open else []
        words = ["campaign", "run", self.folder, "--engine", "workqueue", "--json", *address, *options]
        return Manager([self.place.program, *words], host, Path(stem + ".err"), Path(stem + ".json"))

    def worker(self, words, host: Host, cores: int = 4) -> subprocess.Popen:
        """A worker on `host`, started by the line that the manager printed."""
        options = ["--cores", str(cores), "--workdir", self.place.network.here / "work", "--max-backoff", "1"]
        return host.start([*words[:-2], *options, *words[-2:]], self.place.folder / f"worker-{host.name}.log")

    def finished(self) -> int:
        return len(list((self.folder / "results").glob("[0-9a-f]" * 32)))

    def wait_for(self, count: int) -> None:
        wait_until(lambda: self.finished() >= count, f"{count} shards are finished")

    def must_end(self, manager: Manager) -> dict:
        """The manager ends with all done; what it says of its run."""
        check(manager.ended() == 0, f"the manager ended with {manager.process.returncode}: {manager.said()}")
        return json.loads(manager.out.read_text())

    def done_by(self, host: Host) -> int:
        return len(journal.of_worker(self.folder, "done", host.name))

    def wait_for_work_of(self, host: Host, more: int = 1) -> None:
        before = self.done_by(host)
        wait_until(lambda: self.done_by(host) >= before + more, f"{host.name} finishes {more} more shards")

    def wait_for_state(self, figures: str) -> None:
        """These words are in the newest figures of the engine, which the journal has every ten seconds."""
        def states():
            return [event.text + " " for event in journal.events(self.folder) if event.what == "state"]

        wait_until(lambda: states() and figures in states()[-1], f"the engine's figures say {figures}")

    def status(self) -> dict:
        return json.loads(self.place.dumbbell("campaign", "status", self.folder, "--json").stdout)

    def must_be_whole(self, manager_kills: int = 0, put_by_hand: int = 0) -> None:
        """Nothing lost, nothing accepted twice, the bytes of `certify`, and the verifier accepts them.

        A manager that was killed may have kept a result and not have said so; a result that was put there is none of
        its doing.
        """
        status = self.status()
        check(status["complete"] and status["done"] == status["shards"], f"the status is {status}")
        times = journal.times_done(self.folder)
        twice = [shard for shard, count in times.items() if count > 1]
        check(not twice, f"accepted twice: {twice}")
        silent = status["shards"] - len(times) - put_by_hand
        check(0 <= silent <= manager_kills, f"{silent} shards were never done by the journal")
        check(not list((self.folder / "arrived").iterdir()), "results are left in arrived")
        merged = self.place.folder / "merged.dbc"
        done = self.place.dumbbell("campaign", "merge", self.folder, "--out", merged)
        check(done.returncode == 0, f"campaign merge: {done.stderr}")
        check(merged.read_bytes() == self.place.in_one_go(), "the bytes are others than those of certify")
        verdict = self.place.verify("--ratio", CLAIM[0], merged)
        check(verdict.returncode == 0, f"dumbbell-verify: {verdict.stdout} {verdict.stderr}")
        merged.unlink()
        print(f"{status['shards']} shards, each done once; merged: the bytes of certify, verified", flush=True)
