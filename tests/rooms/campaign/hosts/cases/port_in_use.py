"""A second campaign on the port of the first: it says what to do, and the first does not notice."""

from checks import check
from stand_ins import slow


def run(place) -> None:
    manager_host = place.host("manager")
    worker = place.host("worker", program=slow(place.program, 0.1))
    campaign = place.campaign(30)
    second = place.campaign(30, "second")
    manager = campaign.run(manager_host, "--program", place.stand_in)
    words = manager.worker_words()
    refused = second.run(manager_host)
    check(refused.ended() == 2, f"the second ended with {refused.process.returncode}")
    said = refused.said()
    check(said.count("\n") == 1 and "port 9123 is in use" in said and "--port" in said, f"it said {said!r}")
    print(said.strip())
    check(second.finished() == 0 and not refused.out.read_text(), "the second did something")
    campaign.worker(words, worker)
    campaign.must_end(manager)
    campaign.must_be_whole()
