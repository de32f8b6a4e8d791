"""A world of its own for one test: namespaces of network, processes and mounts, which end with it however it ends.

Names, addresses and ports in it collide with nothing outside, so that any number of tests can run at the same time.
"""

import os
import shutil
import signal
import subprocess
import sys
import tempfile

SKIPPED = 77  # ctest's SKIP_RETURN_CODE
INSIDE = "DUMBBELL_HOSTS_WORLD"
UNSHARE = ["unshare", "--net", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc"]
PROBE = "mount -t tmpfs tmpfs /run && ip netns add probe && ip link add bridge type bridge && " \
        "ip link add probe type veth peer name eth0 netns probe"


def skip(why: str) -> None:
    print("=" * 100 + f"\nSKIPPED, NOTHING WAS TESTED: campaigns over several hosts: {why}\n" + "=" * 100,
          file=sys.stderr, flush=True)
    sys.exit(SKIPPED)


def way_in() -> list[str]:
    """The command behind which a program runs in such a world; an unprivileged user needs a namespace of users, too."""
    complaint = ""
    for way in (UNSHARE, [*UNSHARE, "--user", "--map-root-user"]):
        tried = subprocess.run([*way, "sh", "-c", PROBE], capture_output=True, text=True, check=False)
        if tried.returncode == 0:
            return way
        complaint = tried.stderr.strip().splitlines()[-1] if tried.stderr.strip() else f"exit {tried.returncode}"
    return skip(f"no network namespaces can be made here ({complaint}); it takes CAP_SYS_ADMIN and CAP_NET_ADMIN")


def enter() -> str:
    """Runs this program again, inside; there it returns an empty folder on disk, which is gone in the end."""
    if INSIDE in os.environ:
        subprocess.run(["mount", "-t", "tmpfs", "tmpfs", "/run"], check=True)  # `ip netns` keeps its names there
        return os.environ[INSIDE]
    for program in ("ip", "unshare", "nsenter", "setpriv", "mount", "work_queue_worker"):
        if shutil.which(program) is None:
            skip(f"there is no {program} (.ci/install test)")
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
