"""A campaign with a host that will be cut off, and a steady one."""

from stand_ins import slow


def campaign_with_cut_host(place, shards: int, seconds: float, steady_cores: int):
    """The campaign, its manager and the host to cut, which has done some shards; each takes this number of seconds."""
    manager_host = place.host("manager")
    cut, steady = (place.host(name, program=slow(place.program, seconds)) for name in ("cut", "steady"))
    campaign = place.campaign(shards)
    manager = campaign.run(manager_host, "--program", place.stand_in)
    words = manager.worker_words()
    campaign.worker(words, cut)
    campaign.worker(words, steady, cores=steady_cores)
    campaign.wait_for_work_of(cut, 4)
    return campaign, manager, cut, steady
