"""A host is cut off until it is given up; what it had is done elsewhere, and when it comes back it may work again."""

from checks import check
from cut_host import campaign_with_cut_host


def run(place) -> None:
    campaign, manager, cut, _ = campaign_with_cut_host(place, shards=400, seconds=0.9, steady_cores=3)
    cut.cut_off()
    campaign.wait_for_state("workers=1 ")
    cut.connect_again()
    campaign.wait_for_work_of(cut, 4)
    said = campaign.must_end(manager)
    check(said["workers_joined"] >= 3 and said["workers_lost"] >= 1, f"workers: {said}")
    check(said["resent"] > 0, "it had nothing to do when it was cut off: nothing was tried")
    campaign.must_be_whole()
