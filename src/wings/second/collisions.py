"""The claim `collisions`: the file, its pieces and trees; format.md 2, 3 and format-sections.md."""

import body
import cells
import full
import gaps
import perpendicular
import plain
import turning
from demand import decimals, interval_text, part_text, ratio_text
from judge import ends
from tree import walk

# (lemmas, scene, section): the module that knows the section's charts.
SECTIONS = {
    ("1", "dumbbell", "turning"): turning,
    ("1", "dumbbell", "full"): full,
    ("minimal", "dumbbell", "full"): plain,
    ("body", "body", "full"): body.Bodies,
    ("body", "body", "perpendicular"): perpendicular.Perpendicular,
    ("body", "body", "cells"): cells,
}


class Staircase:
    """What is proved: of each piece [a, b], in ascending order, U (None: no bound) and V; for all rho in a pair, or None. `source`
    is what the verdict says of where it comes from. Of rectangles of bodies `pieces` is about what is asked, `told` about all, and
    of the share `decided` of what is asked the number is proved."""

    def __init__(self, scene, rho, heavy_once, pieces, source, told=None, decided=None):
        self.scene, self.rho, self.pieces, self.source = scene, rho, pieces, source
        self.told, self.decided = told or pieces, decided
        self.low, self.high = pieces[0][0], pieces[-1][1]
        self.leap = 2 if rho else 1  # the bounds of a gap differ by at most that
        self.open = sum(u is None or u > v + self.leap for _, _, u, v in self.told)
        self.heavy_once = heavy_once and all(u is not None for _, _, u, _ in pieces)

    def text(self, demand):
        uppers, lowers = zip(*(piece[2:] for piece in self.told))
        rho = f" rho={interval_text(*self.rho)}" if self.rho else ""
        number = sum(u is not None and v < u <= v + self.leap for u, v in zip(uppers, lowers))
        return (f"scene={self.scene} ratio={interval_text(self.low, self.high)}{rho}"
                f" upper={'none' if None in uppers else max(uppers)} lower={min(lowers)} gaps={number} open={self.open}"
                f"{gaps.widest_text(self.pieces, *demand.ratios(self.low, self.high))}"
                f"{'' if self.decided is None else f' decided={decimals(self.decided, 6)}'}"
                f"{' heavy-at-most=1' if self.heavy_once else ''}")

    def not_demanded(self, demand):
        low, high = demand.ratios(self.low, self.high)
        return demand.not_demanded([*(("inertia", "rho") if self.rho else ("ratio",)), "max", "min",
                                    *(("gap", "gaps") if low < high else ()), *(("heavy-at-most",) if self.heavy_once else ()),
                                    *(() if self.decided is None else ("decided",))])

    def missing(self, demand):
        """What is demanded and not proved; None: nothing."""
        low, high = demand.ratios(self.low, self.high)
        most, least, rhos = demand["max"], demand["min"], demand["rho"]
        if low < self.low or high > self.high:
            return part_text(self.low, self.high, low, high, "Q in " if self.rho else "the mass ratios ")
        if rhos and not self.rho[0] <= rhos[0] <= rhos[1] <= self.rho[1]:
            return f"not proved for every rho in {interval_text(*rhos)}"
        where = f" for every {'Q' if self.rho else 'mass ratio'} in {interval_text(low, high)}"
        if most is not None and not covered([(a, b) for a, b, u, _ in self.pieces if u is not None and u <= most], low, high):
            return f"not proved: at most {most} collisions{where}"
        if least is not None and not covered([(a, b) for a, b, _, v in self.pieces if v >= least], low, high):
            return f"not proved: at least {least} collisions{where}"
        width, number = demand["gap"], demand["gaps"]
        if (width, number) != (None, None) and not gaps.is_known_but_in_gaps(self.pieces, low, high, width, number, self.leap):
            return (f"not proved: the greatest number itself{where}, but in gaps"
                    f"{'' if width is None else f' of relative width {ratio_text(width)}'}"
                    f"{'' if number is None else f', at most {number}'}")
        if demand["heavy-at-most"] and not self.heavy_once:
            return "not proved: the heavy mass hits the floor at most once"
        if (self.decided or 0) < (demand["decided"] or 0):
            return (f"not proved: the number of collisions for a share {ratio_text(demand['decided'])} of the bodies, only for "
                    f"{decimals(self.decided or 0, 6)}")
        return None

    def says_nothing(self, demand):
        """No bound is demanded, and none is proved for all mass ratios in question."""
        if demand["max"] is not None or demand["min"] is not None or self.decided:
            return False
        asked = gaps.asked(self.pieces, *demand.ratios(self.low, self.high))
        return any(u is None for u, _ in asked) and any(v == 0 for _, v in asked)


def covered(intervals, low, high):
    """Do closed intervals, in ascending order, cover [low, high]?"""
    for a, b in intervals:
        if a > low:
            return False
        if b >= high:
            return True
        low = max(low, b)
    return False


def check(lines, header, judge, demand):
    """Checks all after the line `claim`. `header` is a key of SECTIONS. The demand says of which part of a rectangle bounds are wanted."""
    section, rho = SECTIONS[header], None
    if section is cells:
        rho, part, whole, decided, source = cells.check(lines, judge, demand)
        return Staircase("body", rho, False, [part], source, [whole], decided)
    every_body = section is perpendicular.Perpendicular
    lo, hi = lines.line("ratio", "ratio", "ratio")
    if not (1 <= lo or every_body) or lo > hi:
        raise lines.wrong("number", "not 1 <= LO <= HI")
    if header[1] == "body":
        rho = tuple(lines.line("rho", "ratio", "ratio"))
        if not (rho[0] <= rho[1] <= 1 and (every_body or 1 <= lo * rho[0])):
            raise lines.wrong("number", "not R0 <= R1 <= 1 <= LO R0")
        section = section(rho)
    number, = lines.line("pieces", "nat")
    if number == 0:
        raise lines.wrong("number", "no piece")
    end, pieces = lo, []
    for k in range(number):
        a, b = lines.line("piece", "ratio", "ratio")
        if a != end or a > b:
            raise lines.wrong("chain", "a piece must begin where the one before ended")
        if b > hi or (k + 1 == number and b != hi):
            raise lines.wrong("chain", "the last piece does not end at HI")
        end = b
        pieces.append((a, b, *piece(lines, section, a, b, judge)))
    kinds = ["split", "count", "outside", "meets", "meets-reversed", "equal-masses", "witness", "open"]
    again = header[2] == "full" and not rho
    if again or rho:
        kinds.insert(7, "once" if again else "orbits" if every_body else "symmetric")
    return Staircase(header[1], rho, again, pieces, f"sha256={lines.trailer(kinds)}")


def piece(lines, section, a, b, judge):
    """Checks a piece after its first line; returns U (or None) and V."""
    bits, = lines.line("bits", "bits")
    upper, = lines.line("upper", "any")
    if upper == "none":
        upper = None
        lines.count("open")
    else:
        upper = lines.value("count", upper)
        cover(lines, section, a, b, upper, bits, judge)
    lower, = lines.line("lower", "count")
    if upper is not None and lower > upper:
        raise lines.wrong("number", "lower above upper")
    if lower > 0:
        witness(lines, section, lower, a, b, bits, judge)
    return upper, lower


def witness(lines, section, lower, a, b, bits, judge):
    kind, *numbers = lines.line("witness", "any", "dyadic", "dyadic", "any", "any")
    if kind not in section.WITNESSES:
        raise lines.wrong("syntax", "unknown kind of witness")
    numbers[2:] = lines.values(numbers[2:], "count", "count")
    lines.count("witness")
    if 1 + numbers[2] + numbers[3] < lower:
        raise lines.wrong("witness", "not certified: V <= 1 + a + b")
    judge(lambda: section.WITNESSES[kind](numbers, a, b), [*numbers, a, b], bits, lines.wrong("witness", "not certified"))


def cover(lines, section, a, b, upper, bits, judge):
    def leaf(fields, box, _share):
        op = fields[0]
        hints = section.LEAVES[chart].get(op)
        if hints is None:
            raise lines.wrong("opcode", "not a line for this place")
        values = lines.values(fields[1:], *["count"] * hints)
        lines.count(op)
        if op == "count" and 1 + sum(values) > upper:
            raise lines.wrong(op, "not certified: the leaf counts more than U collisions")
        judge(lambda: section.leaf(chart, op, values, box, upper), ends(box), bits, lines.wrong(op, "not certified"))

    if not section.LEAVES:
        section.orbits(lines, b, upper, bits, judge)
    for number, chart in enumerate(section.LEAVES):
        fields = lines.next()
        if number == 0 and fields[0] != "chart":
            op = fields[0]
            if op not in section.COVERS:
                raise lines.wrong("opcode", "not a line for this place")
            lines.values(fields[1:])
            lines.count(op)
            if not section.COVERS[op](a, b, upper):
                raise lines.wrong(op, "not certified")
            return
        if fields != ["chart", chart]:
            raise lines.wrong("syntax", f"expected `chart {chart}`")
        walk(lines, {**section.root(chart, b), "q": (a, b)}, leaf)
