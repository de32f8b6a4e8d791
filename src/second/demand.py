"""What is demanded of a file: the claim that the user states."""


class Demand:
    """Of the mass ratios `ratios`, a pair (None: those of the file), no trajectory has more than `most` collisions, and some
    trajectory has `least` (None: nothing is demanded); of this scene and this kind of claim (empty: of any), and if it is of
    bodies of these rho, a pair."""

    ratios = rhos = most = least = None
    scene = claim = ""

    def bounds(self):
        return self.ratios is not None or self.most is not None or self.least is not None

    def text(self):
        """As the verdict repeats it."""
        parts = [f"demanded-ratio={interval_text(*self.ratios)}"] if self.ratios else []
        parts += [f"demanded-rho={interval_text(*self.rhos)}"] if self.rhos else []
        if self.most is not None and self.most == self.least:
            parts.append(f"exactly={self.most}")
        else:
            parts += [f"max={self.most}"] if self.most is not None else []
            parts += [f"min={self.least}"] if self.least is not None else []
        parts += [f"demanded-scene={self.scene}"] if self.scene else []
        parts += [f"demanded-claim={self.claim}"] if self.claim else []
        return "".join(" " + part for part in parts)

    def other(self, scene, claim):
        """Why a file of this scene and claim is not what was demanded; None if it is. Who states a claim means the dumbbell."""
        asked = self.scene or ("dumbbell" if self.bounds() or self.claim else scene)
        if asked != scene:
            return f"the scene is {scene}, and {asked} was demanded (--scene)"
        if self.claim not in ("", claim):
            return f"the claim is {claim}, and {self.claim} was demanded (--claim)"
        return None


def ratio_text(ratio):
    return f"{ratio.numerator}/{ratio.denominator}"


def interval_text(low, high):
    return f"{ratio_text(low)}:{ratio_text(high)}"


def part_text(low, high, first, last):
    """Of a claim about the ratios [low, high] that does not cover [first, last]: what it covers."""
    if high < first or last < low:
        return f"nothing is said of the mass ratios {interval_text(first, last)}, only of {interval_text(low, high)}"
    return (f"of the mass ratios {interval_text(first, last)} only {interval_text(max(low, first), min(high, last))} "
            "are covered")
