"""Certified collision counts of the bouncing dumbbell.

>>> certify(10)
<Certificate of 10/1: N = 4>

What goes in is exact, what comes out is proved, in C++: nothing is computed in Python. docs/13-python.md is the chapter.
"""

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
    certify,
    certify_incoming,
    certify_many,
    certify_starts,
    critical,
    law,
    mean_collisions,
    trace,
    verify,
)

__all__ = [name for name in dir() if not name.startswith("_")]
