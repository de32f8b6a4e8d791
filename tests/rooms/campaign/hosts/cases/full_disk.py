"""A host's disk fills up while it works: its shards are done elsewhere, and nothing half-written counts."""

import journal
from checks import check
from stand_ins import slow


def fill(disk) -> None:
    with open(disk / "fills-it", "wb", buffering=0) as file:
        try:
            while file.write(bytes(1 << 12)):
                pass
        except OSError:
            pass  # no space left


def run(place) -> None:
    manager_host = place.host("manager")
    program = slow(place.program, 0.2)
    small = place.host("small", disk="16m", program=program)
    right = place.host("right", program=program)
    campaign = place.campaign(120)
    manager = campaign.run(manager_host, "--program", place.stand_in)
    words = manager.worker_words()
    worker = campaign.worker(words, small)
    campaign.wait_for_work_of(small, 5)
    fill(small.seen_by(worker) / "work")
    campaign.worker(words, right)
    said = campaign.must_end(manager)
    failures = journal.of_worker(campaign.folder, "failed", small.name)
    # Shards fail there, and now and then one finds room again; or the worker cannot take an order, and leaves.
    check(len(failures) + said["resent"] > 0, f"the disk was large enough: nothing was tried; the run says {said}")
    check(said["given_up"] == 0, f"the run says {said}")
    print(f"failed {len(failures)} times, sent again {said['resent']}:", *{failure.text for failure in failures})
    campaign.must_be_whole()
