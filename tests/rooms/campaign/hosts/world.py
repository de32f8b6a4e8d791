"""A world of its own for one test: namespaces of network, processes and mounts, which end with it however it ends.

Names, addresses and ports in it collide with nothing outside, so that any number of tests can run at the same time.
"""

import os
import signal
import subprocess
import sys
import tempfile

INSIDE = "DUMBBELL_HOSTS_WORLD"
UNSHARE = ["unshare", "--net", "--mount", "--propagation", "unchanged", "--pid", "--fork", "--kill-child", "--mount-proc"]
# Nothing that is mounted from here on is seen outside. In a chroot, where / is no mount, one has to step out of it to
# say so: a process that enters a namespace of mounts, here this very one, is at its root, where PATH means nothing.
ALONE = 'mount --make-rprivate / 2> /dev/null || nsenter --mount=/proc/self/ns/mnt ' \
        '"$(readlink -f "$(command -v mount)")" --make-rprivate / && exec "$@"'
PROBE = "mount -t tmpfs tmpfs /run && ip netns add probe && ip link add bridge type bridge && " \
        "ip link add probe type veth peer name eth0 netns probe && unshare --uts true"


class Forbidden(Exception):
    """The kernel lets nobody here make such a world."""


def way_in() -> list[str]:
    """The command after which a program runs in such a world; an unprivileged user needs a namespace of users, too."""
    complaint = ""
    for user in ([], ["--user", "--map-root-user"]):
        way = [*UNSHARE, *user, "sh", "-c", ALONE, "sh"]
        tried = subprocess.run([*way, "sh", "-c", PROBE], capture_output=True, text=True, check=False)
        if tried.returncode == 0:
            return way
        complaint = complaint or (tried.stderr.strip().splitlines() or [f"exit {tried.returncode}"])[-1]
    raise Forbidden(f"no network namespaces can be made here ({complaint})")


def enter() -> str:
    """Runs this program again, inside; there it returns an empty folder on disk, which is gone in the end."""
    if INSIDE in os.environ:
        subprocess.run(["mount", "-t", "tmpfs", "tmpfs", "/run"], check=True)  # `ip netns` keeps its names there
        return os.environ[INSIDE]
    way = way_in()
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, lambda number, _: sys.exit(128 + number))
    with tempfile.TemporaryDirectory(prefix="dumbbell-hosts-", ignore_cleanup_errors=True) as folder:
        inside = subprocess.Popen(["setpriv", "--pdeathsig", "KILL", *way, sys.executable, *sys.argv],
                                  env={**os.environ, INSIDE: folder})
        try:
            sys.exit(inside.wait())
        finally:
            inside.kill()  # and with it, by --kill-child, everything inside
            inside.wait()


def main() -> int:
    """Prints why there cannot be such a world here, and exits 1 then."""
    try:
        way_in()
    except Forbidden as reason:
        print(reason)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
