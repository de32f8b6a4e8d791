"""A result is there already when a worker brings it: the same counts once, and garbage gives way to the proof."""

import hashlib
import os

import journal
from campaign import Campaign
from checks import check, wait_until
from host import Host
from stand_ins import noted


def ids_under_way(host: Host) -> list[str]:
    """Of orders that a worker has begun, and that are held."""
    orders = [file for file in (host.files / "begun").glob("*") if file.suffix != ".tmp"]
    return [hashlib.sha256(file.read_bytes()).hexdigest()[:32] for file in orders]


def put(campaign: Campaign, name: str, content: bytes) -> None:
    check(not (campaign.folder / "results" / name).exists(), "the shard was no longer under way: nothing was tried")
    beside = campaign.place.folder / "by-hand"
    beside.write_bytes(content)
    os.rename(beside, campaign.folder / "results" / name)


def run(place) -> None:
    truth = place.campaign(40, "truth")
    check(place.dumbbell("campaign", "run", truth.folder).returncode == 0, "the local engine")
    manager_host = place.host("manager")
    host = place.host("worker", program=noted(place.program, str(place.network.here / "begun")))
    campaign = place.campaign(40)
    results = campaign.folder / "results"

    held = host.files / "begun-held"
    held.touch()
    manager = campaign.run(manager_host, "--program", place.stand_in, "--quiet")
    campaign.worker(manager.worker_words(), host, cores=8)
    wait_until(lambda: len(ids_under_way(host)) >= 2, "a worker begins two shards")
    other, same = ids_under_way(host)[:2]
    true_bytes = (truth.folder / "results" / other).read_bytes()
    other_bytes = true_bytes.replace(b"dumbbell-certificate 1", b"dumbbell-certificate 2")
    put(campaign, other, other_bytes)
    put(campaign, same, (truth.folder / "results" / same).read_bytes())
    held.unlink()
    said = campaign.must_end(manager)
    check(said["again"] == 2, f"the run says {said}")
    again = {event.id for event in journal.of_worker(campaign.folder, "again", host.name)}
    check(again == {other, same}, "the journal")
    check((results / other).read_bytes() == true_bytes, "the garbage is still there")
    check((campaign.folder / "rejected" / other).read_bytes() == other_bytes, "the garbage was not kept for a look")
    lines = [line for line in manager.said().splitlines() if "waiting for workers" not in line]
    check(len(lines) == 1 and "two results that differ: the second is kept" in lines[0], f"it said {lines}")
    print(lines[0])
    campaign.must_be_whole(put_by_hand=2)
