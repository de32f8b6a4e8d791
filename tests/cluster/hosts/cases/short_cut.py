"""A host is cut off from the network for some seconds: it works on afterwards, and nothing is lost."""

import time

from checks import check
from stand_ins import slow


def run(place) -> None:
    manager_host = place.host("manager")
    cut, steady = (place.host(name, program=slow(place.program, 0.4)) for name in ("cut", "steady"))
    campaign = place.campaign(100)
    manager = campaign.run(manager_host, "--program", place.stand_in)
    words = manager.worker_words()
    campaign.worker(words, cut)
    campaign.worker(words, steady, cores=2)
    campaign.wait_for_work_of(cut, 4)
    cut.cut_off()
    time.sleep(5)
    before = campaign.done_by(cut)
    campaign.wait_for_work_of(steady, 4)
    check(campaign.done_by(cut) == before, "it was not cut off")
    cut.connect_again()
    campaign.wait_for_work_of(cut, 4)
    said = campaign.must_end(manager)
    # On a busy machine the packaged worker has been seen to start anew by itself: then it joins once more.
    check(said["complete"] and said["rejected"] == 0, f"the run says {said}")
    campaign.must_be_whole()
