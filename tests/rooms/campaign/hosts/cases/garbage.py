"""Hosts return garbage of all kinds, and nothing in the right words: it is rejected, kept for a look at it, and proved
elsewhere."""

import journal
from checks import check
from stand_ins import garblers, slow


def run(place) -> None:
    manager_host = place.host("manager")
    garbling = [place.host(name, program=text) for name, text in garblers(place.program).items()]
    right = place.host("right", program=slow(place.program, 0.4))
    campaign = place.campaign(150)  # enough that each of the others is given something
    manager = campaign.run(manager_host, "--program", place.stand_in)
    words = manager.worker_words()
    for host in [*garbling, right]:
        campaign.worker(words, host, cores=4 if host is right else 1)
    said = campaign.must_end(manager)
    for host in garbling:
        rejections = journal.of_worker(campaign.folder, "rejected", host.name)
        check(campaign.done_by(host) == 0, f"something from {host.name} was accepted")
        check(rejections, f"nothing from {host.name} was rejected")
        print(f"{host.name}: rejected {len(rejections)} times: {rejections[0].text}")
    check(said["rejected"] == len([e for e in journal.events(campaign.folder) if e.what == "rejected"]), f"{said}")
    check(said["given_up"] == 0, f"the run says {said}")
    rejected = {event.id for event in journal.events(campaign.folder) if event.what == "rejected"}
    kept = {file.name for file in (campaign.folder / "rejected").iterdir()}
    check(kept == rejected, f"kept for a look at them: {len(kept)} of {len(rejected)}")
    campaign.must_be_whole()
