"""Without --address the manager is there for its own machine only."""

import sys

from checks import check
from stand_ins import slow

CONNECT = "import socket, sys; socket.create_connection((sys.argv[1], int(sys.argv[2])))"


def run(place) -> None:
    manager_host = place.host("manager", program=slow(place.program, 0.1))
    stranger = place.host("stranger")
    campaign = place.campaign(30)
    manager = campaign.run(manager_host, "--program", place.stand_in, is_open=False)
    words = manager.worker_words()
    check(words[-2:] == ["127.0.0.1", "9123"], f"it listens on {words[-2:]}")
    log = place.folder / "stranger.log"
    for host in (manager_host, stranger):
        tried = host.start([sys.executable, "-c", CONNECT, manager_host.address, "9123"], log)
        check(tried.wait() == 1 and "refused" in log.read_text(), f"{host.name} reaches {manager_host.address}")
        log.unlink()
    campaign.worker(words, manager_host)
    campaign.must_end(manager)
    campaign.must_be_whole()
