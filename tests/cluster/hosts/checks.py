"""How these tests wait, and how they fail."""

import time


class Failed(Exception):
    pass


def check(holds, what: str) -> None:
    if not holds:
        raise Failed(what)


def wait_until(condition, what: str, seconds: float = 240) -> None:
    end = time.monotonic() + seconds
    while not condition():
        check(time.monotonic() < end, f"in {seconds} s it did not happen that {what}")
        time.sleep(0.02)
