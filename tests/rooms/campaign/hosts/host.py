"""Hosts: network namespaces with a link each to one bridge, a name and a disk of their own."""

import subprocess
from pathlib import Path

# In namespaces of its own a host has a name, which it finds in its /etc/hosts (the workers of Debian 12 send whatever
# lies in their memory as their name unless it can be looked up), sees its own files at $3, and may have a small disk.
START = 'hostname "$1" && mount --bind "$2" "$3" && mount --bind "$3/hosts" /etc/hosts && ' \
        'if test -n "$4"; then mount -t tmpfs -o "size=$4" tmpfs "$3/work"; fi && cd "$3" && shift 4 && exec "$@"'


def ip(*words: str) -> None:
    subprocess.run(["ip", *words], check=True)


class Network:
    def __init__(self, folder: Path):
        self.folder = folder
        self.here = folder / "here"  # what a host sees under this name is its own
        self.here.mkdir()
        self.hosts: list[Host] = []
        ip("link", "add", "bridge", "type", "bridge")
        ip("link", "set", "bridge", "up")

    def host(self, name: str, disk: str = "") -> "Host":
        """`disk`: the size of its file system for work, such as 64k; otherwise that of the test's folder."""
        self.hosts.append(Host(self, name, len(self.hosts) + 1, disk))
        return self.hosts[-1]


class Host:
    def __init__(self, network: Network, name: str, number: int, disk: str):
        self.name = name
        self.address = f"10.77.0.{number}"
        self.network = network
        self.disk = disk
        self.link = f"veth{number}"
        self.files = network.folder / f"host-{name}"
        (self.files / "work").mkdir(parents=True)
        (self.files / "hosts").write_text(f"127.0.0.1 localhost\n{self.address} {name}\n")
        ip("netns", "add", name)
        ip("link", "add", self.link, "type", "veth", "peer", "name", "eth0", "netns", name)
        ip("link", "set", self.link, "master", "bridge", "up")
        for words in (("link", "set", "lo", "up"), ("addr", "add", f"{self.address}/24", "dev", "eth0"),
                      ("link", "set", "eth0", "up")):
            subprocess.run(["nsenter", f"--net=/run/netns/{name}", "ip", *words], check=True)  # `ip -n` mounts in vain

    def start(self, words, log: Path) -> subprocess.Popen:
        """`words` run on this host; what they say goes to `log`."""
        command = ["nsenter", f"--net=/run/netns/{self.name}", "unshare", "--uts", "--mount",
                   "--propagation", "unchanged", "sh", "-c", START, "sh",
                   self.name, self.files, self.network.here, self.disk, *words]
        with open(log, "ab") as out:
            return subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=out, stderr=out)

    def seen_by(self, process: subprocess.Popen) -> Path:
        """The files of this host, as a process on it sees them: its small disk, too."""
        return Path(f"/proc/{process.pid}/root{self.network.here}")

    def cut_off(self) -> None:
        ip("link", "set", self.link, "down")

    def connect_again(self) -> None:
        ip("link", "set", self.link, "up")
