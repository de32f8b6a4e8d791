"""The options that state a claim, on the command line and in lists. What one means may depend on others, wherever they stand: so
all are collected first."""

from demand import Demand
from values import Usage, count, mass_ratios, number, one_of, one_or_two, ratio, span

SCENES = "dumbbell", "body"
OF_BODIES = "rho", "inertia", "coin", "rod-mass"

# The options of each kind of claim, besides --scene and --claim.
STARTS = ("ratio", "max", "min", "exactly", "decided")
KINDS = {
    "collisions": ("ratio", *OF_BODIES, "max", "min", "exactly", "gap", "gaps", "heavy-at-most", "decided"),
    "initial-conditions": ("phi", "phidot", "y", "ydot", *STARTS),
    "incoming": STARTS,
    "adiabatic-bounce": ("delta", "heights", "margin", "exponent", "constant", "attained"),
    "adiabatic-run": ("delta", "heights", "margin", "constant", "attained"),
    "adiabatic-scattering": ("delta", "margin", "constant", "attained"),
    "law": (),
}

ANY = number(lambda x: True, "a number")
READERS = {
    "ratio": mass_ratios, "rho": span(ratio), "inertia": span(ratio), "coin": one_of(""),
    "rod-mass": number(lambda x: x >= 0, "a number of at least 0"),
    "max": count, "min": count, "exactly": count, "gaps": count,
    "gap": number(lambda x: 0 <= x < 1, "a width of at least 0 and below 1"),
    "heavy-at-most": one_of("1"),
    "phi": span(ANY), "phidot": span(ANY), "y": span(ANY), "ydot": span(ANY),
    "decided": number(lambda x: 0 <= x <= 1, "a share from 0 to 1"),
    "delta": span(ANY), "heights": span(ANY), "margin": ANY, "exponent": ANY,
    "constant": one_or_two(ANY), "attained": one_or_two(ANY),
    "scene": one_of(*SCENES), "claim": one_of(*KINDS),
}

# What an option says in place of others.
INSTEAD = {
    "exactly": ("--exactly N is --max N and --min N", ("max", "min")),
    "coin": ("--coin is --rho 1 and --inertia 4", ("rho", "inertia", "rod-mass")),
    "rod-mass": ("--rod-mass tells rho and Q", ("rho", "inertia")),
}


def take(word, words, given, names=READERS):
    """Puts the option `word`, if it is one of `names`, into `given`, with its value, which may be the next of `words`."""
    option, equals, value = word.partition("=")
    name = option[2:]
    if not option.startswith("--") or name not in names or (equals and name == "coin"):
        return False
    if name in given:
        raise Usage(f"{option} is given twice")
    if not equals and name != "coin":
        if not words:
            raise Usage(f"no value after {option}")
        value = words.pop(0)
    given[name] = value
    return True


def demand_of(given):
    """What the options, {name: text}, demand together."""
    demand = Demand({name: READERS[name](f"--{name}", text) for name, text in given.items()})
    kind = demand["claim"] or "collisions"
    for name in given:
        if name not in (*KINDS[kind], "scene", "claim"):
            kinds = " or ".join(claim for claim, names in KINDS.items() if name in names)
            raise Usage(f"--{name} is about --claim {kinds}, not {kind}")
    for name, (text, others) in INSTEAD.items():
        if name in given and any(other in given for other in others):
            raise Usage(f"{text}: give it without them")
    if "exactly" in given:
        demand["max"] = demand["min"] = demand.pop("exactly")
    if kind == "initial-conditions" and "ratio" in given and span(ratio)("--ratio", given["ratio"])[0] < 1:
        raise Usage(f"starts need a mass ratio of at least 1, heavy/light, not {given['ratio'][:60]}")
    if kind != "adiabatic-bounce" and any(len(set(demand[name] or ())) > 1 for name in ("constant", "attained")):
        raise Usage(f"two numbers are for adiabatic-bounce: {kind} has one --constant and one --attained")
    if demand["scene"] == "body" or any(name in given for name in OF_BODIES):
        state_body(demand, given)
    return demand


def state_body(demand, given):
    """The options that say which bodies are meant: in the end rho and Q, which is called inertia."""
    if (demand["scene"] or "body") != "body":
        raise Usage(f"--rho, --inertia, --coin and --rod-mass are about bodies, not --scene {demand['scene']}")
    demand["scene"] = "body"
    if demand.pop("coin", None) is not None:
        demand.update(rho=(1, 1), inertia=(4, 4))
    if "rod-mass" in demand:
        q, other = demand.pop("ratio", (1, 2))
        if q != other:
            raise Usage("--rod-mass needs one mass ratio: --ratio RATIO")
        rho, inertia = rod(q, demand.pop("rod-mass"))
        demand.update(rho=(rho, rho), inertia=(inertia, inertia))
    if "ratio" in demand:
        raise Usage("bodies have no --ratio: their Q is --inertia")
    if demand["rho"] and demand["rho"][1] > 1:
        raise Usage(f"--rho is at most 1, not {given['rho'][:60]}")
    if any(name in demand for name in ("max", "min", "gap", "gaps")) and not (demand["rho"] and demand["inertia"]):
        raise Usage("a bound for a body needs --rho and --inertia, or --coin, or --ratio with --rod-mass")


def rod(q, mu):
    """rho and Q of the dumbbell with mass ratio q whose rod has mu times the mass of its ends: L70 (d)."""
    d1 = (2 * q / (1 + q) + mu) / (2 * (1 + mu))
    rho = (2 + mu * (1 + q)) / (2 * q + mu * (1 + q))
    return rho, d1 * d1 / (d1 * d1 * rho - mu / (6 * (1 + mu)))
