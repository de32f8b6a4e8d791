"""How much a part of the benchmarks measures."""
from enum import IntEnum


class Effort(IntEnum):
    SHORTEST = 0  # each benchmark once: that it works, no figures
    QUICK = 1     # fewer repetitions, no job over two seconds
    WHOLE = 2

    def of(self, shortest, quick, whole):
        return (shortest, quick, whole)[self]
