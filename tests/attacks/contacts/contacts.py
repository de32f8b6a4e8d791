#!/usr/bin/env python3
"""Rays beside tangency, crest, corner and slope 1: what both verifiers say of their contacts, against at least 700 bits.

    contacts.py BOUNDS COUNT [--second FOLDER]

BOUNDS is the program `contact_bounds`; DUMBBELL_TEST_SCALE in the environment takes so many times as many. A ray is (c, kappa, rho) in units of 2^-bits; its contact is the least root x of
f = rho sin x - kappa x - c, up to pi/2 with a light wall (rho = 1), up to pi with the bridge. f is concave: so the contact is
not before x iff x <= 0, or x <= crest and f(x) <= 0, and not behind x iff x >= crest or f(x) >= 0."""

import argparse
import multiprocessing
import os
import random
import subprocess
import sys
from collections import Counter
from fractions import Fraction
from pathlib import Path

from mpmath import mp, mpf

BATCH = 250
PRECISIONS = {53: 240, 64: 80, 96: 240, 128: 120, 200: 80, 256: 120, 512: 30, 1024: 6, 2048: 1, 4096: 1}
BRIDGES = [Fraction(1), Fraction(1, 2), Fraction(1, 16), Fraction(1, 1024), Fraction(3, 4), Fraction(5, 8), Fraction(7, 16)]


class Ray:
    """f as above, its crest z and its height there. `wall`: a light wall."""

    def __init__(self, bits, c, kappa, rho, wall):
        self.bits, self.rho, self.wall = bits, rho, wall
        mp.prec = max(700, bits + 300)
        self.kappa, self._kappa, self._rho = Fraction(kappa, 1 << bits), mpf(kappa) / (1 << bits), number(rho)
        end, slope = mp.pi / 2 if wall else mp.pi, self._kappa / self._rho
        self.z = min(mp.acos(max(min(slope, 1), -1)), end)
        self.c = self._c = 0
        top = self.f(self.z)
        self.c = Fraction(c(int(top * (1 << bits))), 1 << bits)
        self._c = number(self.c)
        self.top = top - self._c

    def f(self, x):
        return self._rho * mp.sin(x) - self._kappa * x - self._c

    def is_hit(self):
        return self.top > 0

    def not_before(self, x):
        return x <= 0 or x <= self.z and self.f(x) <= 0

    def not_behind(self, x):
        return x >= self.z or self.f(x) >= 0


def number(x):
    return mpf(x.numerator) / x.denominator


def drawn(chance, bits):
    """A ray whose numbers have no more than so many bits."""
    one, wall = 1 << bits, chance.random() < 0.6
    rho = Fraction(1) if wall else chance.choice(BRIDGES)
    steep = int(rho * one)
    near = int(2 ** chance.uniform(0, bits))  # units
    kappa = chance.choice((steep - near, steep - near, steep - near, near, -near, chance.randrange(-steep, steep)))
    kappa = min(max(kappa, 1 - steep), steep - 1)

    def height(top):
        """Of the ray over the corner; top: of the tangent."""
        by = chance.choice((chance.randrange(1000), int(2 ** chance.uniform(0, max(top.bit_length(), 1))))) + 1
        c = chance.choice((top - by, top + by, top - by, top + by, by, chance.randrange(max(top, 1))))
        return min(max(c, 0), one - 1)

    return Ray(bits, height, kappa, rho, wall)


def other_guess(chance, ray):
    """A number beside the crest."""
    away = chance.choice((-1, 1)) * int(2 ** chance.uniform(0, ray.bits))
    return Fraction(max(int(ray.z * (1 << ray.bits)) + away, 0), 1 << ray.bits)


def claims_of_program(program, rays, chance):
    """A ray and its claims, words and bounds, line by line."""
    asked = [(ray, bits, other_guess(chance, ray)) for ray in rays for bits in ((0, 53) if ray.bits == 53 else (ray.bits,))]
    numbers = [(ray.c, ray.kappa, z, 0 if ray.wall else ray.rho) for ray, _, z in asked]
    lines = [" ".join([str(bits), *(f"{x.numerator:x}/{x.denominator:x}" for x in ray)]) for (_, bits, _), ray in zip(asked, numbers)]
    said = subprocess.run([program], input="\n".join(lines), text=True, stdout=subprocess.PIPE, check=True).stdout.splitlines()
    for (ray, _, z), line in zip(asked, said, strict=True):
        claims = []
        for word in line.split():
            name, _, values = word.partition("=")
            values = [Fraction(*(int(part, 16) for part in value.split("/"))) for value in values.split(",") if value]
            claims.append((name, *values) if name != "below" else (name, z))
        yield ray, claims


def claims_of_second(ray):
    """The same of the second verifier; what it leaves undecided is no claim."""
    from body import Body, Flight
    from fixed import Undecided, half_pi, interval, pi
    from full import below_time, clears_bridge, steep_time
    from rays import earliest, latest, misses

    c, kappa, rho = interval(ray.c), interval(ray.kappa), interval(ray.rho)
    body = Body((4 / ray.rho, 4 / ray.rho), (ray.rho, ray.rho))
    ask = [("misses", lambda: misses(c, kappa, half_pi())), ("first", lambda: earliest(c, kappa)), ("last", lambda: latest(c, kappa))]
    if not ray.wall:
        ask = [("misses", lambda: clears_bridge(c, kappa, rho)), ("last", lambda: steep_time(kappa, rho, rho)),
               ("first", lambda: earliest((c / rho).lower(), (kappa / rho).lower(), pi())),
               ("below", lambda: below_time(c, kappa, rho)), ("first", lambda: body.contacts(Flight(kappa, None, interval(0), c)))]
    for name, question in ask:
        try:
            found = question()
        except Undecided:
            continue
        if found is True or found is None and name == "first":
            yield ("misses",)
        elif type(found) is tuple:  # a body's contacts
            yield "first", Fraction(found[0].lo, 1 << ray.bits)
            yield "last", Fraction(found[0].hi, 1 << ray.bits)
            if found[1]:
                yield ("meets",)
        elif found:
            yield name, Fraction(found.lo, 1 << ray.bits)
            if name == "last" and ray.wall:
                yield ("meets",)


def is_true(ray, claim):
    name, *values = claim
    if not values:
        return ray.is_hit() == (name == "meets")
    x, *functions = map(number, values)
    if name == "below":
        return ray.f(x) > 0
    if functions:
        side = 1 if name == "first" else -1
        if not ((mp.sin(x) - functions[0]) * side >= 0 and (functions[1] - mp.cos(x)) * side >= 0):
            return False
    return not ray.is_hit() or (ray.not_before(x) if name == "first" else ray.not_behind(x))


def attacked(batch):
    """How often which claim was made, and the false ones, of the rays of one batch."""
    program, seed, bits, size = batch
    import fixed

    chance = random.Random(seed)
    rays = [drawn(chance, bits) for _ in range(size)]
    if seed == 0:  # 2 10^-26 below a tangent of slope 1 - 6 10^-17
        rays.append(Ray(96, lambda top: 33913, 79228162514264332888819981598, Fraction(1), True))
        bits = 96
    fixed.set_precision(bits)
    mp.prec = max(700, bits + 300)
    said = [("verifier", *answer) for answer in claims_of_program(program, rays, chance)]
    said += [("second", ray, claims_of_second(ray)) for ray in rays]
    counts, false = Counter(rays=len(rays)), []
    for who, ray, claims in said:
        for claim in claims:
            counts[who, claim[0]] += 1
            if not is_true(ray, claim):
                false.append(f"{who}: {claim[0]} is false: bits {ray.bits} c {ray.c} kappa {ray.kappa} rho {ray.rho} wall {ray.wall}")
    return counts, false


def main():
    options = argparse.ArgumentParser()
    options.add_argument("bounds")
    options.add_argument("count", type=int)
    options.add_argument("--second", default=Path(__file__).resolve().parents[3] / "src/wings/second")
    options = options.parse_args()
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(options.second))
    scale, chance = int(os.environ.get("DUMBBELL_TEST_SCALE", 1)), random.Random(58)
    precisions = [96, *chance.choices(list(PRECISIONS), PRECISIONS.values(), k=options.count * scale // BATCH - 1)]
    batches = [(options.bounds, seed, bits, BATCH) for seed, bits in enumerate(precisions)]
    counts, false = Counter(), []
    with multiprocessing.Pool(os.cpu_count() if scale > 1 else 1) as pool:
        for some, wrong in pool.imap(attacked, batches):
            counts += some
            false += wrong
    rays = counts.pop("rays")
    print(f"{rays} rays;", ", ".join(f"{who} {claim} {n}" for (who, claim), n in sorted(counts.items())))
    print(*false[:20], f"{len(false)} false claims", sep="\n")
    # Who says nothing says nothing false.
    silent = [name for name in [("verifier", "clears"), ("verifier", "passes"), ("verifier", "below"), ("second", "below"),
                                *((who, claim) for who in ("verifier", "second") for claim in ("first", "last", "meets", "misses"))]
              if counts[name] < rays / 50]
    if silent:
        print("too few claims:", silent)
    return bool(false or silent)


if __name__ == "__main__":
    sys.exit(main())
