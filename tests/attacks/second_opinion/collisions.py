"""The claim `collisions`: the file, its pieces and trees; format.md 2, 3 and format-sections.md."""

import full
import plain
import turning
import wedge
from judge import ends
from tree import walk

# (lemmas, scene, section): the module that knows the section's charts.
SECTIONS = {
    ("1", "dumbbell", "turning"): turning,
    ("1", "dumbbell", "full"): full,
    ("minimal", "dumbbell", "full"): plain,
    ("1", "wedge", "turning"): wedge,
    ("1", "hybrid", "turning"): wedge,
}


def check(lines, header, judge):
    """Checks all after the line `claim` and returns the verdict's fields. `header` is a key of SECTIONS."""
    section = SECTIONS[header]
    lo, hi = lines.line("ratio", "ratio", "ratio")
    if not 1 <= lo <= hi:
        raise lines.wrong("1 <= LO <= HI is required")
    pieces, = lines.line("pieces", "nat")
    if pieces == 0:
        raise lines.wrong("no pieces")
    end, uppers, lowers, gaps, opens = lo, [], [], 0, 0
    for k in range(pieces):
        a, b = lines.line("piece", "ratio", "ratio")
        if a != end or not a <= b or (k + 1 == pieces and b != hi):
            raise lines.wrong("the pieces do not tile the ratio")
        end = b
        upper, lower = piece(lines, section, header[1], a, b, judge)
        uppers.append(upper)
        lowers.append(lower)
        gaps += upper is not None and upper == lower + 1
        opens += upper is None or upper > lower + 1
    kinds = ["split", "count", "outside", "meets", "meets-reversed", "equal-masses", "witness", "open"]
    if header[2] == "full":
        kinds.insert(7, "once")
    checksum = lines.trailer(kinds)
    heavy = " heavy-at-most=1" if header[2] == "full" and None not in uppers else ""
    upper = "none" if None in uppers else max(uppers)
    return (f"scene={header[1]} ratio={spelled(lo)}:{spelled(hi)} upper={upper} lower={min(lowers)} gaps={gaps} "
            f"open={opens}{heavy} sha256={checksum}")


def spelled(ratio):
    return f"{ratio.numerator}/{ratio.denominator}"


def piece(lines, section, scene, a, b, judge):
    """Checks a piece after its first line; returns U (or None) and V."""
    bits, = lines.line("bits", "nat")
    if not 53 <= bits <= 4096:
        raise lines.wrong("bits from 53 to 4096")
    fields = lines.next()
    if fields == ["upper", "none"]:
        upper = None
        lines.count("open")
    elif fields[0] == "upper":
        upper, = lines.values(fields[1:], "count")
        cover(lines, section, scene, a, b, upper, bits, judge)
    else:
        raise lines.wrong("expected `upper`")
    lower, = lines.line("lower", "count")
    if upper is not None and lower > upper:
        raise lines.wrong("the lower bound is above the upper one")
    if lower > 0:
        kind = section.WITNESS
        values = lines.line(f"witness {kind}" + (" 0b0" if kind == "wedge" else ""),
                            *["dyadic"] * (1 if kind == "wedge" else 2), "count", "count")
        lines.count("witness")
        if 1 + values[-2] + values[-1] < lower:
            raise lines.wrong("the witness has less than `lower` collisions")
        judge(lambda: section.witness(values, a, b), [*values, a, b], bits, lines.wrong("the witness is not certified"))
    return upper, lower


def cover(lines, section, scene, a, b, upper, bits, judge):
    def leaf(fields, box, _share):
        op = fields[0]
        hints = section.LEAVES[chart].get(op)
        if hints is None:
            raise lines.wrong(f"no node of the chart {chart}: {op}")
        values = lines.values(fields[1:], *["count"] * hints)
        lines.count(op)
        if op == "count" and 1 + sum(values) > upper:
            raise lines.wrong("the leaf counts more than `upper` collisions")
        judge(lambda: section.leaf(chart, op, values, box), ends(box), bits,
              lines.wrong(f"the leaf `{op}` is not certified"))

    for number, chart in enumerate(section.CHARTS):
        fields = lines.next()
        if number == 0 and scene == "dumbbell" and fields == ["equal-masses"]:
            lines.count("equal-masses")
            if not (a == b == 1 and upper >= 2):
                raise lines.wrong("equal-masses needs the ratio 1 and upper >= 2")
            return
        if fields != ["chart", chart]:
            raise lines.wrong(f"expected `chart {chart}`")
        walk(lines, {**section.root(chart, b), "q": (a, b)}, leaf)
