"""The manager is killed, and killed again, and asked to stop; started again on the same port it finds its workers."""

import signal

from checks import check
from stand_ins import slow


def run(place) -> None:
    manager_host = place.host("manager")
    hosts = [place.host(name, program=slow(place.program, 0.2)) for name in ("left", "right")]
    campaign = place.campaign(400)  # enough that a host which comes late to the last run still finds work
    workers = []
    kills = 0
    for number in (signal.SIGKILL, signal.SIGKILL, signal.SIGTERM):
        manager = campaign.run(manager_host, "--program", place.stand_in)
        words = manager.worker_words()
        workers = workers or [campaign.worker(words, host) for host in hosts]
        campaign.wait_for(campaign.finished() + 10)
        manager.process.send_signal(number)
        kills += number == signal.SIGKILL
        check(manager.ended() == -number, f"{number!r} ended the manager with {manager.process.returncode}")
    check("stopped by SIGTERM" in manager.said() and "shards left: the same command goes on" in manager.said(), f"it said {manager.said()!r}")
    manager = campaign.run(manager_host, "--program", place.stand_in)
    said = campaign.must_end(manager)
    check(all(worker.poll() is None for worker in workers), "a worker went away")
    check(said["workers_joined"] >= len(hosts) and said["again"] == 0, f"the last run says {said}")
    check(all(campaign.done_by(host) > 0 for host in hosts), "a host did nothing")
    campaign.must_be_whole(manager_kills=kills)
