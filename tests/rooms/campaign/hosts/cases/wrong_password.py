"""A worker with another password gets nothing, and keeps nobody from working."""

from checks import check, wait_until
from stand_ins import noted


def run(place) -> None:
    manager_host = place.host("manager")
    program = noted(place.program, str(place.network.here / "begun"))
    stranger, friend = (place.host(name, program=program) for name in ("stranger", "friend"))
    campaign = place.campaign(60)
    manager = campaign.run(manager_host, "--program", place.stand_in)
    words = manager.worker_words()
    wrong = stranger.files / "password"
    wrong.write_text("another secret, as long as the right one\n")
    wrong.chmod(0o600)
    campaign.worker([str(wrong) if word.endswith("/password") else word for word in words], stranger)
    log = place.folder / "worker-stranger.log"
    wait_until(lambda: log.exists() and "wrong password" in log.read_text(), "the stranger is turned away")
    campaign.worker(words, friend)
    said = campaign.must_end(manager)
    check(said["complete"] and campaign.done_by(stranger) == 0, f"the run says {said}")
    check(not (stranger.files / "begun").exists(), "the stranger got an order")
    campaign.must_be_whole()
