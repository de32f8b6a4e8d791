"""No worker comes for a minute: the manager says so, once, and how to start one; then one comes, and does the work."""

import time

from checks import check, wait_until


def run(place) -> None:
    manager_host = place.host("manager")
    worker = place.host("worker")
    campaign = place.campaign(30)
    begin = time.monotonic()
    manager = campaign.run(manager_host, "--quiet")
    words = manager.worker_words()
    wait_until(lambda: "no worker for" in manager.said(), "the manager says that nobody came")
    check(time.monotonic() - begin > 55, "it said so too early")
    time.sleep(5)
    lines = manager.said().splitlines()
    check(len(lines) == 2 and "to start one: " + " ".join(words) in lines[1], f"it said {lines}")
    print(lines[1])
    campaign.worker(words, worker)
    campaign.must_end(manager)
    campaign.must_be_whole()
