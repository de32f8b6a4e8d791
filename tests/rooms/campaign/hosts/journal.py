"""A campaign's journal, as these tests read it."""

from collections import Counter
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Event:
    time: float
    what: str
    id: str
    worker: str
    seconds: float
    text: str


def events(folder: Path) -> list[Event]:
    file = folder / "journal"
    found = []
    for line in file.read_text().splitlines() if file.exists() else []:
        fields = line.split("\t")
        if len(fields) == 6:
            found.append(Event(float(fields[0]), *fields[1:4], float(fields[4]), fields[5]))
    return found


def of_worker(folder: Path, what: str, worker: str) -> list[Event]:
    return [event for event in events(folder) if event.what == what and event.worker == worker]


def times_done(folder: Path) -> Counter:
    return Counter(event.id for event in events(folder) if event.what == "done")
