"""Certified collision counts of the bouncing dumbbell.

>>> certify(10)
<Certificate: --ratio 10 --exactly 4>

What goes in is exact, what comes out is proved, in C++: nothing is computed in Python. docs/13-python.md is the chapter.
"""

import atexit as _atexit
import functools as _functools

from . import _dumbbell
from ._dumbbell import (
    BrokenInvariant,
    Certificate,
    Collision,
    InputError,
    ResourceError,
    StartsCertificate,
    Trace,
    Verification,
    __version__,
)


def _named(function):
    """The same as a function of this module, which pickle finds by its name."""

    @_functools.wraps(function)
    def call(*given, **options):
        return function(*given, **options)

    call.__module__, call.__qualname__ = __name__, function.__name__
    return call


for _name in ("certify", "certify_incoming", "certify_many", "certify_starts", "critical", "law", "mean_collisions", "trace", "verify"):
    globals()[_name] = _named(getattr(_dumbbell, _name))

__all__ = [name for name in dir() if not name.startswith("_")]

_atexit.register(_dumbbell._interpreter_ends)
