"""Programs on the workers' hosts in place of the real one: shell scripts that take `campaign work ... ORDER RESULT`."""


def slow(program: str, seconds: float) -> str:
    """The real one, after a while: its shards take milliseconds, and the faults need time to happen."""
    return f'#!/bin/sh\nsleep {seconds}\nexec {program} "$@"\n'
