"""The claim `initial-conditions`: format-initial.md."""

from fractions import Fraction

from contact import Air, has_no_collision, is_first_contact
from demand import decimals, interval_text, ratio_text
from failure import Rejected
from fixed import hull, interval, sin_cos
from flight import counts_within, first_reflection, greatest_number
from judge import ends
from tree import walk
from work import spend

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


class Leaves:
    """What some leaves say together: how many collisions, and on which share of what is in question exactly how many."""

    def __init__(self):
        self.lows, self.highs, self.decided = set(), set(), Fraction(0)

    def add(self, low, high, share):
        """A leaf of `share`, none of them if it is 0; `high` None: no bound."""
        if share:
            self.lows.add(low)
            self.highs.add(high)
            self.decided += share if low == high else 0

    def bounds(self):
        return (0, None) if None in self.highs else (min(self.lows), max(self.highs))


def share_of(box, root, asked):
    """How much of the box that is asked about is in the box of a leaf: the product over the axes of overlap / width. A point on
    the border of two leaves is in the upper one."""
    share = Fraction(1)
    for axis, (low, high) in root.items():
        (a, b), (first, last) = box[axis], asked.get(axis, (low, high))
        spend(10_000 + sum(x.denominator.bit_length() for x in (share, a, b, first, last)) ** 2 // 500)
        if first < last:
            share *= max(Fraction(0), min(b, last) - max(a, first)) / (last - first)
        elif a < b and not (a <= first < b or first == b == high):
            return 0
    return share


class Starts:
    """What is proved of the starts in a box, whose sides are named as in the file: `found` says it of all, `asked` of those that are
    demanded."""

    open = 0

    def __init__(self, claim, box, found, asked, source):
        self.claim, self.box, self.found, self.asked, self.source = claim, box, found, asked, source

    def text(self, _demand):
        sides = "".join(f" {name}={interval_text(*side)}" for name, side in self.box.items())
        (least, most), decided = self.found.bounds(), self.found.decided
        return (f"claim={self.claim}{sides} collisions={least}:{bound_text(most)} "
                f"decided={'1' if decided == 1 else decimals(decided, 12)}")

    def not_demanded(self, demand):
        return demand.not_demanded([*self.box, "max", "min", "decided"])

    def missing(self, demand):
        """What is demanded and not proved; None: nothing."""
        for name, (low, high) in self.box.items():
            first, last = demand[name] or (low, high)
            if first < low or last > high:
                return f"nothing is said of all {name} in {interval_text(first, last)}, only of {interval_text(low, high)}"
        least, most = self.asked.bounds()
        if demand["max"] is not None and (most is None or most > demand["max"]):
            return f"not proved: at most {demand['max']} collisions from the box"
        if demand["min"] is not None and least < demand["min"]:
            return f"not proved: at least {demand['min']} collisions from the box"
        if self.asked.decided < (demand["decided"] or 0):
            return f"not proved: the number of collisions for a share {ratio_text(demand['decided'])} of the box"
        return None

    def says_nothing(self, demand):
        """No bound is demanded, none holds for all starts in question, and of no part of them the number is known."""
        return (demand["max"] is None and demand["min"] is None and self.asked.bounds() == (0, None)
                and self.asked.decided == 0)


def bound_text(bound):
    return "none" if bound is None else str(bound)


def check(lines, judge, demand):
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
    sides = {**{axis: box[axis] for axis in AXES}, "ratio": box["q"]}
    return check_leaves(lines, judge, demand, "initial-conditions", sides, box, bits, leaf_holds, ends)


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


def check_leaves(lines, judge, demand, claim, sides, root, bits, holds, numbers):
    """Checks all from the line `between` on. holds(box, low, high, window) is what must be certified of a leaf, numbers(box) are
    those that this is about."""
    claimed = lines.line("between", "any", "any")
    claimed = lines.value("nat", claimed[0]), None if claimed[1] == "none" else lines.value("nat", claimed[1])
    claim_line = lines.number
    cut = {"q" if name == "ratio" else name: demand[name] for name in sides if demand[name]}
    found = Leaves()
    asked = Leaves() if cut else found

    def leaf(fields, box, share):
        op = fields[0]
        if op not in ("exactly", "between") and fields != ["open"]:
            raise lines.wrong("opcode", "not a line for this place")
        lines.count(op)
        low, high, window = (0, None, None) if op == "open" else read_leaf(lines, fields)
        found.add(low, high, share)
        if cut:
            asked.add(low, high, share_of(box, root, cut))
        if op != "open":
            judge(lambda: holds(box, low, high, window), numbers(box), bits, lines.wrong(op, "not certified"))

    walk(lines, root, leaf)
    if claimed != found.bounds():
        raise Rejected(claim_line, "between", f"expected {found.bounds()[0]} {bound_text(found.bounds()[1])}")
    source = f"sha256={lines.trailer(['split', 'exactly', 'between', 'open'])}"
    return Starts(claim, sides, found, asked, source)
