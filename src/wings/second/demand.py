"""What is demanded of a file: the claim that the user states."""

from fractions import Fraction

SHOWN = ("ratio", "inertia", "rho", "max", "min", "gap", "gaps", "heavy-at-most", "scene", "claim", "phi", "phidot", "y", "ydot", "decided")


class Demand(dict):
    """What each option demands, by its name (of --exactly N, max and min; of bodies, rho and Q as `inertia`). What is not demanded
    is None."""

    def __missing__(self, name):
        return None

    def ratios(self, low, high):
        """The mass ratios in question, or for bodies Q, of a file about [low, high]."""
        return self["ratio"] or self["inertia"] or (low, high)

    def bounds(self):
        """Is something demanded of all trajectories?"""
        return any(name in self for name in ("ratio", "inertia", "rho", "max", "min", "gap", "gaps", "heavy-at-most"))

    def is_exact(self):
        return self["max"] is not None and self["max"] == self["min"]

    def text(self):
        """As the verdict repeats it."""
        parts = []
        for name in SHOWN:
            value, label = self[name], name if name in ("max", "min") else f"demanded-{name}"
            if name == "max" and self.is_exact():
                label = "exactly"
            if value is not None and not (name == "min" and self.is_exact()):
                parts.append(f" {label}={spelled(value)}")
        return "".join(parts)

    def not_demanded(self, names):
        """The end of the verdict: what was not demanded of these."""
        left = [name for name in names if name not in self and not (self.is_exact() and name in ("gap", "gaps", "decided"))]
        return f" not-demanded={','.join(left)}" if self and left else ""

    def other(self, scene, claim):
        """Why a file of this scene and claim is not what was demanded; None if it is. Who states a claim means the dumbbell."""
        asked = self["scene"] or ("dumbbell" if self.bounds() or self["claim"] else scene)
        if asked != scene:
            return f"the scene is {scene}, and {asked} was demanded (--scene)"
        if (self["claim"] or claim) != claim:
            return f"the claim is {claim}, and {self['claim']} was demanded (--claim)"
        return None


def ratio_text(ratio):
    return f"{ratio.numerator}/{ratio.denominator}"


def decimals(share, places):
    """Cut off, not rounded."""
    digits = f"{share.numerator * 10**places // share.denominator:0{places + 1}d}"
    return f"{digits[:-places]}.{digits[-places:]}"


def spelled(value):
    """An interval, a fraction, a whole number or a word."""
    if isinstance(value, tuple):
        return interval_text(*value)
    return ratio_text(value) if isinstance(value, Fraction) else str(value)


def interval_text(low, high):
    return f"{ratio_text(low)}:{ratio_text(high)}"


def part_text(low, high, first, last, what="the mass ratios "):
    """Of a claim about the ratios [low, high] that does not cover [first, last]: what it covers."""
    if high < first or last < low:
        return f"nothing is said of {what}{interval_text(first, last)}, only of {interval_text(low, high)}"
    return f"of {what}{interval_text(first, last)} only {interval_text(max(low, first), min(high, last))} are covered"
