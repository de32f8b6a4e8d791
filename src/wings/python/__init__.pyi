from collections.abc import Iterable
from decimal import Decimal
from fractions import Fraction
from os import PathLike
from typing import Final, Literal, Optional, SupportsIndex, Tuple, Union

__version__: str

Number = Union[str, SupportsIndex, Fraction, Decimal, float]
"""Exactly: a float is its exact value, a decimal in text is as it is written."""
Ratio = Union[Number, Tuple[Number, Number]]
"""A mass ratio, or a range of them: '1:100' or (1, 100)."""
Quantity = Union[Number, Tuple[Number, Number]]
Path = Union[str, PathLike[str], PathLike[bytes]]
_Bytes = bytes
Content = Union[bytes, Path]
Section = Literal["turning", "full", "plain"]
Enclosure = Tuple[float, float]

class InputError(ValueError):
    """What cannot be taken; of what has a wrong type it is a TypeError, too."""
class ResourceError(RuntimeError): ...
class BrokenInvariant(RuntimeError): ...

class Verification:
    verdict: Final[Literal["verified", "rejected", "unsupported", "unreadable", "limit", "open"]]
    text: Final[str]
    sha256: Final[str]
    def __bool__(self) -> bool: ...

class Certificate:
    def __init__(self, file: Content, *, jobs: int = 1) -> None: ...
    ratio: Final[Tuple[Fraction, Fraction]]
    scene: Final[Literal["dumbbell", "body"]]
    rho: Final[Optional[Fraction]]
    lower: Final[int]
    upper: Final[Optional[int]]
    pieces: Final[Tuple[Tuple[Fraction, Fraction, int, Optional[int]], ...]]
    bytes: Final[_Bytes]
    sha256: Final[str]
    demand: Final[str]
    def verify(self, *, jobs: int = 1) -> Verification: ...
    def save(self, path: Path) -> None: ...
    def svg(self) -> str: ...
    def _repr_svg_(self) -> Optional[str]: ...
    def __hash__(self) -> int: ...

class StartsCertificate:
    lower: Final[int]
    upper: Final[Optional[int]]
    shares: Final[list[Tuple[int, Optional[int], Fraction, Fraction]]]
    mean: Final[Tuple[Fraction, Optional[Fraction]]]
    undecided: Final[Fraction]
    bytes: Final[_Bytes]
    sha256: Final[str]
    demand: Final[str]
    def verify(self, *, jobs: int = 1) -> Verification: ...
    def svg(self) -> str: ...
    def _repr_svg_(self) -> Optional[str]: ...

class Collision:
    heavy: Final[bool]
    time: Final[Enclosure]
    phi: Final[Enclosure]
    y: Final[Enclosure]
    phidot_before: Final[Enclosure]
    phidot_after: Final[Enclosure]
    ydot_before: Final[Enclosure]
    ydot_after: Final[Enclosure]
    grazing_sine: Final[Enclosure]

class Trace:
    lower: Final[int]
    upper: Final[Optional[int]]
    collisions: Final[list[Collision]]

def certify(q: Optional[Ratio] = None, *, section: Section = "turning", gap: Number = "1e-6", jobs: int = 1,
            budget: Optional[float] = None, rho: Optional[Number] = None,
            inertia: Optional[Ratio] = None, coin: bool = False, rod_mass: Optional[Number] = None) -> Certificate: ...
def certify_many(ratios: Iterable[Ratio], *, section: Section = "turning", gap: Number = "1e-6", jobs: int = 1,
                 budget: Optional[float] = None) -> list[Certificate]: ...
def verify(certificate: Content, *, jobs: int = 1, budget: Optional[float] = 30,
           **claims: Union[Quantity, None]) -> Verification: ...
def critical(n: SupportsIndex, digits: int = 15, *, budget: Optional[float] = None) -> Tuple[Decimal, Decimal]: ...
def law(q: Number) -> Tuple[int, int]: ...
def trace(q: Ratio, *, phi: Quantity, phidot: Quantity, y: Quantity, ydot: Quantity, digits: int = 0) -> Trace: ...
def certify_starts(q: Ratio, *, phi: Quantity, phidot: Quantity, y: Quantity, ydot: Quantity, boxes: int = 50000,
                   digits: int = 0, jobs: int = 1, budget: Optional[float] = None) -> StartsCertificate: ...
def certify_incoming(q: Number, *, boxes: int = 50000, jobs: int = 1,
                     budget: Optional[float] = None) -> StartsCertificate: ...
def mean_collisions(q: Number) -> Enclosure: ...
