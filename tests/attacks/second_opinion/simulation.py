"""The dumbbell as lemmas.md L0 has it, in plain doubles: a point above the humps A cos(psi - j pi), A = r for even j (the heavy
mass; rho for a body of body.md) and 1 for odd j (the light one), reflected by (1). Nothing of the checker's formulas."""

import math


class Doubtful(Exception):
    """A contact too near to a tangent, or to a corner, for doubles."""


def _bisect(positive, low, high):
    for _ in range(70):
        middle = (low + high) / 2
        low, high = (middle, high) if positive(middle) else (low, middle)
    return low


class Dumbbell:
    """A state (psi, yhat) with its velocity; `hump` is the one that it stands on, None in the air; `time` since the start."""

    def __init__(self, r, psi, y, velocity, hump=None, rho=None):
        self.rho = r if rho is None else rho
        self.r, self.psi, self.y, self.velocity, self.hump, self.time = r, psi, y, velocity, hump, 0.0

    def _size(self, j):
        return self.rho if j % 2 == 0 else 1.0

    def reflect(self):
        """Reflects the velocity at the hump it stands on."""
        t = -self._size(self.hump) * math.sin(self.psi - self.hump * math.pi)
        x, y = self.velocity
        push = 2 * (y - t * x) / (t * t + self.r)
        self.velocity = x + push * t, y - push * self.r

    def advance(self):
        """Flies to the next contact and stands there; False if there is none."""
        x, y = self.velocity
        if abs(x) < 1e-12:
            raise Doubtful
        side, slope = math.copysign(1, x), y / abs(x)
        j = round(self.psi / math.pi)
        for _ in range(60):
            enter = max(0.0, side * (j * math.pi - self.psi) - math.pi / 2)
            leave = side * (j * math.pi - self.psi) + math.pi / 2
            if slope >= 0 and self.y + slope * enter > 1:
                return False
            if j != self.hump and leave > enter:
                size, angle = self._size(j), self.psi - j * math.pi

                def above(s):
                    return self.y + slope * s - size * math.cos(angle + side * s)
                lowest = _bisect(lambda s: slope + size * side * math.sin(angle + side * s) < 0, enter, leave)
                if abs(above(lowest)) < 1e-9:
                    raise Doubtful
                if above(lowest) < 0:
                    if above(enter) < 1e-9:
                        raise Doubtful
                    s = _bisect(lambda s: above(s) > 0, enter, lowest)
                    self.time += s / abs(x)
                    self.psi, self.y, self.hump = self.psi + side * s, self.y + slope * s, j
                    return True
            j += int(side)
        raise Doubtful

    def collisions(self):
        """The number of collisions to come, and the time of the first (None) and its hump."""
        count, first = 0, None
        while self.advance():
            count += 1
            first = first or (self.time, self.hump)
            self.reflect()
            if count > 10000:
                raise Doubtful
        return count, first
