"""A host is cut off from the network for some seconds: it works on afterwards, and nothing is lost."""

import time

from checks import check
from cut_host import campaign_with_cut_host


def run(place) -> None:
    campaign, manager, cut, steady = campaign_with_cut_host(place, shards=100, seconds=0.4, steady_cores=2)
    cut.cut_off()
    time.sleep(5)
    # What was being fetched from the host may still be waited for until now, and then be there.
    campaign.wait_for_work_of(steady)
    before = campaign.done_by(cut)
    campaign.wait_for_work_of(steady, 4)
    check(campaign.done_by(cut) == before, "it was not cut off")
    cut.connect_again()
    campaign.wait_for_work_of(cut, 4)
    said = campaign.must_end(manager)
    check(said["complete"] and said["rejected"] == 0, f"the run says {said}")
    campaign.must_be_whole()
