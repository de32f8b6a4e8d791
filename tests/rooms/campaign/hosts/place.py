"""Where a case takes place: the programs, the network, a folder on disk."""

import stat
import subprocess
from pathlib import Path

from campaign import CLAIM, Campaign
from checks import check
from host import Host, Network


class Place:
    def __init__(self, program: str, verifier: str, folder: Path):
        self.program = str(Path(program).resolve())
        self.verifier = str(Path(verifier).resolve())
        self.folder = folder
        self.network = Network(folder)
        self.certificate = b""

    def dumbbell(self, *words) -> subprocess.CompletedProcess:
        return self.here(self.program, *words)

    def verify(self, *words) -> subprocess.CompletedProcess:
        return self.here(self.verifier, *words)

    def here(self, *words) -> subprocess.CompletedProcess:
        return subprocess.run([str(word) for word in words], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False)

    def in_one_go(self) -> bytes:
        """The certificate of the claim, by `certify`."""
        if not self.certificate:
            file = self.folder / "one.dbc"
            done = self.dumbbell("certify", *CLAIM, "--out", file)
            check(done.returncode == 0, f"certify: {done.stderr}")
            self.certificate = file.read_bytes()
        return self.certificate

    def campaign(self, shards: int, name: str = "campaign") -> Campaign:
        return Campaign(self, name, shards)

    def host(self, name: str, disk: str = "", program: str = "") -> Host:
        """`program`: the text of what this host has as the program, at `stand_in`."""
        host = self.network.host(name, disk)
        if program:
            file = host.files / "dumbbell"
            file.write_text(program)
            file.chmod(file.stat().st_mode | stat.S_IXUSR)
        return host

    @property
    def stand_in(self) -> str:
        """Each host has a program of its own here."""
        return str(self.network.here / "dumbbell")
