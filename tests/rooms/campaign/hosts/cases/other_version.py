"""A host has another version of the program: it refuses the orders and says why, and they are processed elsewhere."""

import journal
from checks import check, wait_until
from stand_ins import of_version, slow


def run(place) -> None:
    manager_host = place.host("manager")
    other = place.host("other", program=of_version(place.program, "0.0.9"))
    right = place.host("right", program=slow(place.program, 0.2))
    campaign = place.campaign(100)
    manager = campaign.run(manager_host, "--program", place.stand_in)
    words = manager.worker_words()
    campaign.worker(words, other)
    wait_until(lambda: len(journal.of_worker(campaign.folder, "failed", other.name)) >= 3, "it refused three times")
    campaign.worker(words, right)
    said = campaign.must_end(manager)
    refusals = journal.of_worker(campaign.folder, "failed", other.name)
    check(campaign.done_by(other) == 0, "something from another version was accepted")
    for refusal in refusals:
        check("the order comes from dumbbell 0.0.9" in refusal.text and "install the manager's version" in refusal.text,
              f"it said {refusal.text!r}")
    check(any("it is left out" in refusal.text for refusal in refusals), "it was not left out")
    check(said["failed"] == len(refusals) <= 10 and said["given_up"] == 0, f"the run says {said}")
    print(f"refused {len(refusals)} times, then left out: {refusals[0].text}")
    campaign.must_be_whole()
