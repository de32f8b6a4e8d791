"""How these tests wait, and how they fail."""

import time

PATIENCE = 3000  # seconds: less than ctest waits, and more than anything takes on a busy machine


class Failed(Exception):
    pass


def check(holds, what: str) -> None:
    if not holds:
        raise Failed(what)


def wait_until(condition, what: str) -> None:
    end = time.monotonic() + PATIENCE
    while not condition():
        check(time.monotonic() < end, f"in {PATIENCE} s it did not happen that {what}")
        time.sleep(0.02)
