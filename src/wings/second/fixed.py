"""Intervals whose ends are integers: n stands for n / 2**bits.

Every rounding is a floor or a ceiling of exact integers; no floating-point number takes part in any bound.
The precision is one for the whole program: `set_precision` first. An interval made before that raises ValueError.
"""

from fractions import Fraction

from work import kept, spend

GREATEST_KEPT = 64  # precisions whose pi is kept


class Undecided(Exception):
    """The enclosures of this precision are too wide to go on."""


class _Interval:
    """The real numbers from lo / 2**bits to hi / 2**bits. A comparison is True only if it holds for all of them:
    `not a < b` does not mean `a >= b`."""

    __slots__ = ("lo", "hi")

    def __init__(self, lo, hi):
        self.lo, self.hi = lo, hi

    def __add__(self, other):
        other = interval(other)
        return Interval(self.lo + other.lo, self.hi + other.hi)

    def __sub__(self, other):
        other = interval(other)
        return Interval(self.lo - other.hi, self.hi - other.lo)

    def __rsub__(self, other):
        return interval(other) - self

    def __neg__(self):
        return Interval(-self.hi, -self.lo)

    def __mul__(self, other):
        if type(other) is int:
            return Interval(self.lo * other, self.hi * other) if other >= 0 else Interval(self.hi * other, self.lo * other)
        other = interval(other)
        a, b, c, d = self.lo, self.hi, other.lo, other.hi
        if a >= 0 and c >= 0:
            low, high = a * c, b * d
        else:
            products = (a * c, a * d, b * c, b * d)
            low, high = min(products), max(products)
        return Interval(low >> _bits, -(-high >> _bits))

    __radd__, __rmul__ = __add__, __mul__

    def __truediv__(self, other):
        other = interval(other)
        a, b, c, d = self.lo << _bits, self.hi << _bits, other.lo, other.hi
        if c <= 0:  # who divides by what is negative changes both signs
            raise Undecided("the divisor may be 0 or negative")
        return Interval(a // (d if a >= 0 else c), -(-b // (c if b >= 0 else d)))

    def __rtruediv__(self, other):
        return interval(other) / self

    def __lt__(self, other):
        return self.hi < interval(other).lo

    def __le__(self, other):
        return self.hi <= interval(other).lo

    def __gt__(self, other):
        return self.lo > interval(other).hi

    def __ge__(self, other):
        return self.lo >= interval(other).hi

    def lower(self):
        return point(self.lo)

    def upper(self):
        return point(self.hi)

    def middle(self):
        """One of its points, near its middle."""
        return point((self.lo + self.hi) // 2)

    def __float__(self):
        """About the middle: for guesses, never for a bound."""
        try:
            return (self.lo + self.hi) / (2 << _bits)
        except OverflowError:
            return 1e300 if self.lo > 0 else -1e300


def _outlived(_interval):
    raise ValueError("an interval of another precision")


_bits = _term_cost = 0
_half_pi = Interval = None


def set_precision(bits):
    """From here on. Each precision has a class of intervals; when it is over, they lose their ends, so that no operation takes
    them for others."""
    global _bits, _half_pi, _term_cost, Interval
    if bits == _bits and bits in kept:
        return
    if Interval:
        Interval.lo = Interval.hi = property(_outlived)
    spend(2000)
    Interval = type("Interval", (_Interval,), {"__slots__": ()})
    _bits, _term_cost = bits, 350 + bits + bits * bits // 2600
    if bits not in kept:
        if len(kept) == GREATEST_KEPT:
            kept.clear()
        spend(3000 + 30 * bits + bits * bits // 50)
        kept[bits] = _enclose_half_pi()
    _half_pi = Interval(*kept[bits])


def precision():
    return _bits


def interval(value):
    """Encloses an int, a Fraction or a float (the number that it is); leaves an Interval alone."""
    if type(value) is Interval:
        return value
    if type(value) is int:
        return Interval(value << _bits, value << _bits)
    value = Fraction(value)
    scaled = value.numerator << _bits
    return Interval(scaled // value.denominator, -(-scaled // value.denominator))


def span(low, high):
    """The interval from the lower end of one to the upper end of the other, if it is one."""
    if low.lo > high.hi:
        raise Undecided("an empty interval")
    return Interval(low.lo, high.hi)


def point(n):
    """The single number n / 2**bits."""
    return Interval(n, n)


def hull(*parts):
    parts = [interval(part) for part in parts]
    return Interval(min(part.lo for part in parts), max(part.hi for part in parts))


def least(a, b):
    """Encloses the lesser of the two numbers."""
    a, b = interval(a), interval(b)
    return Interval(min(a.lo, b.lo), min(a.hi, b.hi))


def greatest(a, b):
    return -least(-interval(a), -interval(b))


def meet(a, b):
    """Encloses a number that lies in both."""
    a, b = interval(a), interval(b)
    if a.lo > b.hi or b.lo > a.hi:
        raise Undecided("an empty intersection")
    return Interval(max(a.lo, b.lo), min(a.hi, b.hi))


def square(a):
    """Never negative, which a * a may be where a may be 0."""
    squares = a * a
    return squares if a.lo >= 0 or a.hi <= 0 else Interval(0, -(-max(a.lo * a.lo, a.hi * a.hi) >> _bits))


def half_pi():
    return _half_pi


def pi():
    return _half_pi * 2


def _enclose_half_pi():
    """pi/2 = 8 atan(1/5) - 2 atan(1/239). The floors of atan's alternating series lose less than 2 units in each term,
    and the first term left out is less than 2 units."""
    guard = 24

    def atan(m):
        power, total, terms = (1 << (_bits + guard)) // m, 0, 0
        while power:
            total += (-1) ** terms * (power // (2 * terms + 1))
            power //= m * m
            terms += 1
        return total, 2 * (terms + 1)

    (a, pad_a), (b, pad_b) = atan(5), atan(239)
    middle, pad = 8 * a - 2 * b, 8 * pad_a + 2 * pad_b
    return (middle - pad) >> guard, -(-(middle + pad) >> guard)


def _sin_cos_number(z):
    """Encloses sine and cosine of the number z / 2**bits, 0 <= z <= 2 * 2**bits.

    The terms z^k / k! are computed with floors. Term k is too small by at most 2 units: the error e of one becomes at
    most 2 e / k + 1 in the next, and terms 0 and 1 are exact. Once a term is 0, it and the next are at most 2 units,
    and both series alternate and decrease from there on, so what is left out is at most 2 units in each."""
    term, k = 1 << _bits, 0
    sums = [0, 0]
    if not 0 <= z <= 2 << _bits:
        raise ValueError("the series of sine and cosine")
    while term:
        sums[k & 1] += -term if k & 2 else term
        k += 1
        term = (term * z >> _bits) // k
    spend(k * _term_cost)
    pad = 2 * (k + 1)
    one = 1 << _bits
    return (Interval(max(sums[1] - pad, 0), min(sums[1] + pad, one)),
            Interval(max(sums[0] - pad, -one), min(sums[0] + pad, one)))


def _sin_cos_end(x):
    """The same for any number x / 2**bits: x - k pi/2 lies near [-pi/4, pi/4], where the sine increases and the cosine
    falls with the distance from 0."""
    k = (2 * x + _half_pi.lo) // (2 * _half_pi.lo)
    y = point(x) - _half_pi * k
    if not (y > -1 and y < 1):
        raise Undecided("an angle too large for the precision")
    (s0, c0), (s1, c1) = _sin_cos_number(abs(y.lo)), _sin_cos_number(abs(y.hi))
    sine = hull(-s0 if y.lo < 0 else s0, -s1 if y.hi < 0 else s1)
    cosine = hull(c0, c1, 1) if y.lo <= 0 <= y.hi else hull(c0, c1)
    return [(sine, cosine), (cosine, -sine), (-sine, -cosine), (-cosine, sine)][k % 4]


def sin_cos(x):
    """Encloses the sine and the cosine of every number in the interval x."""
    half = _half_pi
    if 0 <= x.lo and x.hi <= half.lo:  # sine increases, cosine falls
        sine, cosine = _sin_cos_number(x.lo)
        if x.lo != x.hi:
            sine_end, cosine_end = _sin_cos_number(x.hi)
            sine, cosine = Interval(sine.lo, sine_end.hi), Interval(cosine_end.lo, cosine.hi)
        return sine, cosine
    # All multiples m pi/2 that the interval may contain: extrema of the sine at odd m, of the cosine at even m.
    first = -(-x.lo // (half.hi if x.lo >= 0 else half.lo))
    last = x.hi // (half.lo if x.hi >= 0 else half.hi)
    if last - first >= 3:
        spend(10 * _term_cost)
        return hull(-1, 1), hull(-1, 1)
    (sine, cosine), (sine_end, cosine_end) = _sin_cos_end(x.lo), _sin_cos_end(x.hi)
    sine, cosine = hull(sine, sine_end), hull(cosine, cosine_end)
    for m in range(first, last + 1):
        if m % 2:
            sine = hull(sine, 1 if m % 4 == 1 else -1)
        else:
            cosine = hull(cosine, 1 if m % 4 == 0 else -1)
    return sine, cosine
