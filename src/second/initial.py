"""The claim `initial-conditions`: format-initial.md."""

from fractions import Fraction

from contact import Air, has_no_collision, is_first_contact
from demand import interval_text, part_text
from failure import Rejected
from fixed import hull, interval, sin_cos
from flight import counts_within, first_reflection, greatest_number
from judge import ends
from tree import walk

HEADER = "1", "dumbbell", "none"
AXES = "phi", "phidot", "y", "ydot"


def above_floor(box):
    """Are both masses above the floor in the whole box?"""
    sine, y = sin_cos(hull(*box["phi"]))[0], box["y"][0]
    r_lo, r_hi = interval(1 / box["q"][1]), interval(1 / box["q"][0])
    return y * (1 + r_lo) + sine.lower() > 0 and y * (1 + r_hi) - r_hi * sine.upper() > 0


def leaf_holds(box, low, high, window):
    """Is it certified that each state has low to high collisions, the first one in the window (None: none given)?"""
    air = Air(box)
    if window is None:
        if high == 0:
            return has_no_collision(air)
        return (low == 0 or (low == 1 and air.v < 0)) and high >= greatest_number(air.r)
    mass, t0, t1 = window
    if not is_first_contact(air, mass, t0, t1):
        return False
    later_least = None if low == 1 else low - 1
    later_most = None if low < high and high >= greatest_number(air.r) else high - 1
    if later_least is None and later_most is None:
        return True
    rays = first_reflection(air, mass, hull(t0, t1))
    return later_least is None if rays is None else counts_within(rays, later_least, later_most)


class Starts:
    """What is proved of all starts: from `least` to `most` collisions (None: no bound), and on the share `decided` of them
    exactly how many. `about` is what the verdict says of them, `low` and `high` are the ends of the mass ratio."""

    def __init__(self, about, ratios, bounds, decided, checksum):
        self.low, self.high = ratios
        self.least, self.most = bounds
        self.decided, self.checksum = decided, checksum
        digits = f"{decided.numerator * 10**12 // decided.denominator:013d}"  # cut off, not rounded
        self.text = (f"{about} ratio={interval_text(*ratios)} collisions={self.least}:{bound_text(self.most)} "
                     f"decided={'1' if decided == 1 else digits[:-12] + '.' + digits[-12:]}")

    def missing(self, demand):
        """What is demanded and not proved; None: nothing."""
        if demand.ratios and (demand.ratios[0] < self.low or demand.ratios[1] > self.high):
            return part_text(self.low, self.high, *demand.ratios)
        if demand.most is not None and (self.most is None or self.most > demand.most):
            return f"not proved: at most {demand.most} collisions from the box"
        if demand.least is not None and self.least < demand.least:
            return f"not proved: at least {demand.least} collisions from the box"
        return None

    def says_nothing(self, demand):
        """No bound is demanded, none holds for all starts, and of no part of them the number is known."""
        return (demand.most is None and demand.least is None and self.most is None and self.least == 0
                and self.decided == 0)


def bound_text(bound):
    return "none" if bound is None else str(bound)


def check(lines, judge):
    """Checks all after the line `claim`."""
    box = {"q": read_ratio(lines)}
    for axis in AXES:
        box[axis] = tuple(lines.line(axis, "signed", "signed"))
        if box[axis][0] > box[axis][1]:
            raise lines.wrong("number", "not LO <= HI")
    bits, = lines.line("bits", "bits")
    if all(box[axis][0] <= 0 <= box[axis][1] for axis in ("phidot", "ydot")):
        raise lines.wrong("rest", "the box holds a dumbbell at rest")
    if box["phi"][1] - box["phi"][0] > 7:
        raise lines.wrong("number", "phi spans more than 7")
    judge(lambda: above_floor(box), ends(box), max(bits, 512),
          lines.wrong("floor", "not certified: both masses start above the floor"))
    about = "".join(f" {axis}={interval_text(*box[axis])}" for axis in AXES)
    return check_leaves(lines, judge, f"claim=initial-conditions{about}", box, box["q"], bits, leaf_holds, ends)


def read_ratio(lines):
    low, high = lines.line("ratio", "ratio", "ratio")
    if low > high:
        raise lines.wrong("number", "not LO <= HI")
    if low < 1:
        raise lines.wrong("number", "not 1 <= LO")
    return low, high


def read_leaf(lines, fields):
    """The line of a leaf but `open`: the least and the greatest number of collisions, and the window of the first (None: none
    is given)."""
    op, *fields = fields
    hints = 1 if op == "exactly" else 2
    if len(fields) not in (hints, hints + 3):
        raise lines.wrong("syntax", "wrong number of values")
    numbers = lines.values(fields[:hints], *["nat"] * hints)
    low, high, window = numbers[0], numbers[-1], None
    if len(fields) > hints:
        if fields[hints] not in ("light", "heavy"):
            raise lines.wrong("syntax", "not a mass")
        window = fields[hints], *lines.values(fields[hints + 1:], "dyadic", "dyadic")
        if not 0 < window[1] < window[2]:
            raise lines.wrong("number", "not 0 < t0 < t1")
        if low == 0:
            raise lines.wrong("number", "a first contact and no collision")
    if op == "exactly" and (window is None) != (low == 0):
        raise lines.wrong("syntax", "`exactly` has a window iff its number is not 0")
    if op == "between" and not low < high:
        raise lines.wrong("number", "not a < b")
    return low, high, window


def check_leaves(lines, judge, about, root, ratios, bits, holds, numbers):
    """Checks all from the line `between` on. holds(box, low, high, window) is what must be certified of a leaf, numbers(box) are
    those that this is about."""
    claimed = lines.line("between", "any", "any")
    claimed = [lines.value("nat", claimed[0]), None if claimed[1] == "none" else lines.value("nat", claimed[1])]
    claim_line = lines.number
    lows, highs, decided = set(), set(), Fraction(0)

    def leaf(fields, box, share):
        nonlocal decided
        op = fields[0]
        if op not in ("exactly", "between") and fields != ["open"]:
            raise lines.wrong("opcode", "not a line for this place")
        lines.count(op)
        low, high, window = (0, None, None) if op == "open" else read_leaf(lines, fields)
        lows.add(low)
        highs.add(high)
        if op == "exactly":
            decided += share
        if op != "open":
            judge(lambda: holds(box, low, high, window), numbers(box), bits, lines.wrong(op, "not certified"))

    walk(lines, root, leaf)
    found = [0, None] if None in highs else [min(lows), max(highs)]
    if claimed != found:
        raise Rejected(claim_line, "between", f"expected {found[0]} {bound_text(found[1])}")
    checksum = lines.trailer(["split", "exactly", "between", "open"])
    return Starts(about, ratios, found, decided, checksum)
