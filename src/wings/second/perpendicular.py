"""Scene body, section perpendicular: format-sections.md, section 5; Theorem B, L83 and L87. One rho or more, each piece of Q by one line."""

from body import Bodies
from cells import no_more


class Perpendicular(Bodies):
    LEAVES = {}

    def __init__(self, rho):
        super().__init__(rho)
        # Of the least Q: greater ones have as many (L83).
        self.WITNESSES = {kind: lambda values, a, _b, holds=holds: holds(values, a, a) for kind, holds in self.WITNESSES.items()}

    def orbits(self, lines, b, upper, bits, judge):
        """The line that proves `upper` up to Q = b."""
        op, *values = lines.next()
        if op != "orbits":
            raise lines.wrong("opcode", "not a line for this place")
        if len(values) % 2 == 0:
            raise lines.wrong("syntax", "expected `orbits end`, and pairs `x p`")
        end, *rest = lines.values(values, "count", *["count", "dyadic"] * (len(values) // 2))
        lines.count(op)
        judge(lambda: no_more(upper, list(zip(rest[::2], rest[1::2])), end, self.rho, b),
              [b, *self.rho, *(number for number in rest[1::2] if number)], bits, lines.wrong(op, "not certified"))
