"""Three workers, of which one is killed and one joins late."""

from checks import check
from stand_ins import slow


def run(place) -> None:
    manager_host = place.host("manager")
    program = slow(place.program, 0.2)
    killed, steady, late = (place.host(name, program=program) for name in ("killed", "steady", "late"))
    campaign = place.campaign(400)
    manager = campaign.run(manager_host, "--program", place.stand_in)
    words = manager.worker_words()
    victim = campaign.worker(words, killed)
    campaign.worker(words, steady)
    campaign.wait_for_work_of(killed, 5)
    victim.kill()
    campaign.worker(words, late)
    said = campaign.must_end(manager)
    for host in (killed, steady, late):
        check(campaign.done_by(host) > 0, f"{host.name} did nothing")
    check(said["workers_joined"] >= 3 and said["workers_lost"] >= 1, f"workers: {said}")
    check(said["resent"] > 0, "the killed worker had nothing to do: nothing was tried")
    check((said["left"], said["again"], said["rejected"], said["failed"]) == (0, 0, 0, 0), f"the run says {said}")
    campaign.must_be_whole()
    print(f"manager's overhead: {1000 * said['manager_seconds_a_shard']:.2f} ms a shard "
          f"({said['accepted']} shards, {said['resent']} sent again, {said['seconds']:.1f} s)")
