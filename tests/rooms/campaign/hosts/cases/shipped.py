"""Without --program the manager sends its own: workers need nothing but an empty folder, and leave it so."""

from pathlib import Path

from checks import check, wait_until


def run(place) -> None:
    manager_host = place.host("manager")
    hosts = [place.host(name) for name in ("left", "right")]
    campaign = place.campaign(250)
    manager = campaign.run(manager_host)
    words = manager.worker_words()
    workers = [campaign.worker(words, host) for host in hosts]
    own = Path(place.program).read_bytes()
    for host in hosts:
        campaign.wait_for_work_of(host)
        sent = list((host.files / "work").glob("*/cache/*dumbbell*"))
        check([file.read_bytes() for file in sent] == [own], f"{host.name} has the programs {sent}")
    campaign.must_end(manager)
    for host, worker in zip(hosts, workers):
        worker.terminate()
        wait_until(lambda: worker.poll() is not None, "the worker ends")
        left = list((host.files / "work").iterdir())
        check(not left, f"{host.name} is left with {left}")
    check(not list(Path("/run").glob("dumbbell-campaign-*")), "the manager's copy of the program is left")
    campaign.must_be_whole()
