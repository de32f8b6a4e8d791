"""What a file may cost. Work is counted in steps, not by a clock: a busy machine has the same verdict."""

from failure import Limit

UNITS_PER_SECOND = 300_000_000  # about: on the machine where this was measured
_budget = _left = float("inf")
kept = {}  # what was computed within this budget, so that no file is judged by what was before it


def allow(seconds):
    """From here on so much may be spent."""
    global _budget, _left
    _budget, _left = seconds, seconds * UNITS_PER_SECOND
    kept.clear()


def spend(units):
    """Units of work, before they are done. Raises Limit if there are none left."""
    global _left
    _left -= units
    if _left < 0:
        raise Limit(f"more work than the budget of {float(_budget):g} s: --budget allows more")
