"""Operations and bounces: what Google Benchmark measures, as ratios to plain double in the same run."""
from driver import google, tables
from driver.goals import Goal

PLAIN = "plain double, libm"
# Method, greatest ratio to the plain bounce. `batch plain` is the scalar kernel: one ray at a time.
BOUNCE_GOALS = [
    ("batch plain, two-sided", 2.0), ("batch plain, one-sided", 1.0),
    ("batch avx2, two-sided", 0.7), ("batch avx2, one-sided", 0.4),
    ("batch avx512, two-sided", 0.35), ("batch avx512, one-sided", 0.2),
]
PEERS = ("CGAL", "Arb", "MPFI")


def columns(results):
    """Groups and methods, each in the order of the program."""
    return list(dict.fromkeys(group for group, _ in results)), list(dict.fromkeys(method for _, method in results))


def as_json(results):
    return [{"group": group, "method": method, **values} for (group, method), values in results.items()]


def operations(bin_folder, effort):
    results = google.run(bin_folder / "bench_operations", effort.of(1, 3, 9), effort.of(0, 0.01, 0.01))
    groups, methods = columns(results)
    plain = {group: results[group, "double"]["ns"] for group in groups}
    rows = [[method, *(tables.ratio(results[group, method]["ns"] / plain[group]) for group in groups)] for method in methods]
    rows.append(["ns in double", *(f"{plain[group]:.2g}" for group in groups)])
    tables.show("One operation, over the same in double (libm's sine and cosine); BigInterval with its bits", ["", *groups], rows)
    return as_json(results), []


def bounce(bin_folder, effort):
    results = google.run(bin_folder / "bench_bounce", effort.of(1, 3, 9), effort.of(0, 0.01, 0.05))
    groups, methods = columns(results)
    plain = {group: results[group, PLAIN]["ns"] for group in groups}

    def ratios(method):
        return [results[group, method]["ns"] / plain[group] for group in groups if (group, method) in results]

    rows = [[method, *(tables.ratio(value) for value in ratios(method))] for method in methods]
    rows.append(["ns of the plain bounce", *(f"{plain[group]:.0f}" for group in groups)])
    tables.show("One bounce, over the plain one", ["", *groups], rows, [
        "one-sided: an upper bound of the count; at least: a lower bound; two-sided: both. All but the first line are rigorous.",
        "batch: the kernel of src/batch, `plain` one ray at a time; Interval, BigInterval, CGAL, Arb, MPFI: the general",
        "count of src/model, the same template for all of them."])
    goals = []
    for method, goal in BOUNCE_GOALS:
        worst = max(zip(ratios(method), groups), default=(None, "on this machine"))
        goals.append(Goal(f"bounce, {method}, over plain double (its worst: {worst[1]})", goal, worst[0]))
    return as_json(results), goals + [beaten(results, groups, methods, kernel, sides)
                                      for kernel in ("batch plain", "batch") for sides in ("one-sided", "two-sided")]


def beaten(results, groups, methods, kernel, sides):
    """The fastest peer, over the fastest kernel of those that are called so."""
    own = [method for method in methods if method.startswith(kernel) and method.endswith(sides)]
    peers = [method for method in methods if method.startswith(PEERS) and method.endswith(sides)]
    least = min(min(results[group, method]["ns"] for method in peers) / min(results[group, method]["ns"] for method in own)
                for group in groups)
    what = "the fastest kernel" if kernel == "batch" else kernel
    return Goal(f"fastest peer over {what}, {sides}", 1, least, at_least=True)
