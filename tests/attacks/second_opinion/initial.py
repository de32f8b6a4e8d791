"""The claim `initial-conditions`: format-initial.md."""

from fractions import Fraction

from collisions import spelled
from contact import Air, has_no_collision, is_first_contact
from fixed import hull, interval, sin_cos
from flight import counts_within, first_reflection, greatest_number
from grammar import Rejected
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


def check(lines, judge):
    """Checks all after the line `claim` and returns the verdict's fields."""
    box = {"q": read_ratio(lines)}
    for axis in AXES:
        box[axis] = tuple(lines.line(axis, "signed", "signed"))
        if box[axis][0] > box[axis][1]:
            raise lines.wrong("LO <= HI is required")
    bits = read_bits(lines)
    if all(box[axis][0] <= 0 <= box[axis][1] for axis in ("phidot", "ydot")):
        raise lines.wrong("the box holds a dumbbell at rest")
    if box["phi"][1] - box["phi"][0] > 7:
        raise lines.wrong("phi is wider than 7")
    judge.always(lambda: above_floor(box), ends(box), max(bits, 512),
                 lines.wrong("the masses are not certainly above the floor"))
    sides = " ".join(f"{axis}={spelled(box[axis][0])}:{spelled(box[axis][1])}" for axis in AXES)
    found = check_leaves(lines, judge, box, bits, leaf_holds, ends)
    return f"claim=initial-conditions {sides} ratio={spelled(box['q'][0])}:{spelled(box['q'][1])} {found}"


def read_ratio(lines):
    low, high = lines.line("ratio", "ratio", "ratio")
    if not 1 <= low <= high:
        raise lines.wrong("1 <= LO <= HI is required of the ratio")
    return low, high


def read_bits(lines):
    bits, = lines.line("bits", "nat")
    if not 53 <= bits <= 4096:
        raise lines.wrong("bits from 53 to 4096")
    return bits


def check_leaves(lines, judge, root, bits, holds, numbers):
    """Checks all from the line `between` on and returns the rest of the verdict's fields. holds(box, low, high, window) is what
    must be certified of a leaf, numbers(box) are those that this is about."""
    fields = lines.next()
    if fields[0] != "between":
        raise lines.wrong("expected `between`")
    claimed = fields[1:]
    if claimed != ["0", "none"]:
        lines.values(claimed, "nat", "nat")
    claim_line = lines.number
    lows, highs, decided = [], [], Fraction(0)

    def leaf(fields, box, share):
        nonlocal decided
        op, fields = fields[0], fields[1:]
        if op not in ("exactly", "between", "open"):
            raise lines.wrong(f"no node of this claim: {op}")
        lines.count(op)
        if op == "open":
            lines.values(fields)
            highs.append(None)
            lows.append(0)
            return
        hints = 1 if op == "exactly" else 2
        low, *high = lines.values(fields[:hints], *["nat"] * hints)
        high = high[0] if high else low
        window = None
        if len(fields) > hints:
            if fields[hints] not in ("light", "heavy"):
                raise lines.wrong("expected `light` or `heavy`")
            window = fields[hints], *lines.values(fields[hints + 1:], "dyadic", "dyadic")
            if low == 0 or not 0 < window[1] < window[2]:
                raise lines.wrong("a window without a collision, or not 0 < t0 < t1")
        if op == "exactly" and low > 0 and window is None or op == "between" and not low < high:
            raise lines.wrong("a leaf without its window, or not a < b")
        if op == "exactly":
            decided += share
        lows.append(low)
        highs.append(high)
        judge(lambda: holds(box, low, high, window), numbers(box), bits, lines.wrong(f"the leaf `{op}` is not certified"))

    walk(lines, root, leaf)
    found = ["0", "none"] if None in highs else [str(min(lows)), str(max(highs))]
    if claimed != found:
        raise Rejected(claim_line, f"the leaves say between {' '.join(found)}")
    checksum = lines.trailer(["split", "exactly", "between", "open"])
    digits = f"{decided.numerator * 10**12 // decided.denominator:013d}"  # cut off, not rounded
    return f"collisions={':'.join(found)} decided={digits[:-12]}.{digits[-12:]} sha256={checksum}"
