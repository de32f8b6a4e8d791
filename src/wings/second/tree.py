"""Trees of boxes in pre-order: format.md 3.1. A box is {axis: (lower end, upper end)}, in exact fractions."""

from fractions import Fraction

from work import spend

GREATEST_DEPTH = 400


def walk(lines, root, leaf):
    """Reads a tree and calls leaf(fields, box, share) for each leaf, share = its part of the root box. A complete tree tiles
    its root box, as every split leaves two halves; an axis of one point must not be split."""
    boxes = [(root, dict.fromkeys(root, 0))]
    while boxes:
        box, depths = boxes.pop()
        halvings = sum(depths.values())
        spend(1000 + 2 * halvings)
        fields = lines.next()
        if fields[0] != "split":
            leaf(fields, box, Fraction(1, 1 << halvings))
            continue
        axis = fields[1] if len(fields) == 2 else None
        if axis not in box:
            raise lines.wrong("syntax", "not an axis of this chart")
        if depths[axis] == GREATEST_DEPTH:
            raise lines.wrong("depth", f"more than {GREATEST_DEPTH} splits of one axis")
        low, high = box[axis]
        if low == high:
            raise lines.wrong("split", "an axis of width 0")
        lines.count("split")
        bits = max(number.bit_length() for end in (low, high) for number in end.as_integer_ratio())
        spend(1000 + bits * bits // 1000)
        middle, depths = (low + high) / 2, {**depths, axis: depths[axis] + 1}
        boxes.append(({**box, axis: (middle, high)}, depths))
        boxes.append(({**box, axis: (low, middle)}, depths))
