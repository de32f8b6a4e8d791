"""A host is cut off until it is given up; what it had is done elsewhere, and when it comes back it may work again."""

from checks import check
from stand_ins import slow


def run(place) -> None:
    manager_host = place.host("manager")
    cut, steady = (place.host(name, program=slow(place.program, 0.9)) for name in ("cut", "steady"))
    campaign = place.campaign(400)
    manager = campaign.run(manager_host, "--program", place.stand_in)
    words = manager.worker_words()
    campaign.worker(words, cut)
    campaign.worker(words, steady, cores=3)
    campaign.wait_for_work_of(cut, 4)
    cut.cut_off()
    campaign.wait_for_state("workers=1 ", seconds=80)
    cut.connect_again()
    campaign.wait_for_work_of(cut, 4)
    said = campaign.must_end(manager, seconds=180)
    check((said["workers_joined"], said["workers_lost"]) == (3, 1), f"workers: {said}")
    check(said["resent"] > 0, "it had nothing to do when it was cut off: nothing was tried")
    campaign.must_be_whole()
