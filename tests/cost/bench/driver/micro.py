"""Operations and bounces: what Google Benchmark measures, as ratios to plain double in the same run."""
from driver import google, tables
from driver.goals import Goal

# The best that can be written for one ray with libm, not the shortest: "plain double, libm" starts each contact afresh.
PLAIN = "plain double, warm"
# Method, greatest ratio to the plain bounce: at q = 100, above. `batch portable` is the scalar kernel: one ray at a time.
BOUNCE_GOALS = [
    ("batch portable, two-sided", 1.9, 1.9), ("batch portable, one-sided", 1.0, 1.0),
    ("batch avx2, two-sided", 0.5, 0.5), ("batch avx2, one-sided", 0.4, 0.24),
    ("batch avx512, two-sided", 0.25, 0.25), ("batch avx512, one-sided", 0.2, 0.12),
]
PEERS = ("CGAL", "Arb")


def columns(results):
    """Groups and methods, each in the order of the program."""
    return list(dict.fromkeys(group for group, _ in results)), list(dict.fromkeys(method for _, method in results))


def as_json(results):
    return [{"group": group, "method": method, **values} for (group, method), values in results.items()]


def operations(bin_folder, effort):
    results = google.run(bin_folder / "bench_operations", effort.of(1, 3, 9), effort.of(0, 0.01, 0.01))
    groups, methods = columns(results)
    plain = {group: results[group, "double"]["ns"] for group in groups}
    rows = [[method, *(tables.ratio(results[group, method]["ns"] / plain[group]) if (group, method) in results else ""
                       for group in groups)] for method in methods]
    rows.append(["ns in double", *(f"{plain[group]:.2g}" for group in groups)])
    tables.show("One operation, over the same in double (libm's sine and cosine); BigInterval with its bits", ["", *groups], rows)
    return as_json(results), []


def bounce(bin_folder, effort):
    results = google.run(bin_folder / "bench_bounce", effort.of(1, 3, 9), effort.of(0, 0.01, 0.05), "bounce/")
    groups, methods = columns(results)
    plain = {group: results[group, PLAIN]["ns"] for group in groups}

    def ratios(method):
        return [results[group, method]["ns"] / plain[group] for group in groups if (group, method) in results]

    rows = [[method, *(tables.ratio(value) for value in ratios(method))] for method in methods]
    rows.append(["ns of the plain bounce", *(f"{plain[group]:.0f}" for group in groups)])
    tables.show("One bounce, over the plain one", ["", *groups], rows, [
        "one-sided: an upper bound of the count; at least: a lower bound; two-sided: both. `plain double` and `plain avx512` prove nothing, all others do.",
        "batch: the kernel of src/batch, `portable` one ray at a time; Interval, BigInterval, CGAL, Arb: the general",
        "count of src/model, the same template for all of them."])
    goals = []
    for method, short, long in BOUNCE_GOALS:
        for group in groups:
            measured = results[group, method]["ns"] / plain[group] if (group, method) in results else None
            goals.append(Goal(f"bounce, {method}, over plain double, {group}", short if group == "q=100" else long, measured))
    return as_json(results), goals + [beaten(results, groups, methods, kernel, sides)
                                      for kernel in ("batch portable", "batch") for sides in ("one-sided", "two-sided")]


def beaten(results, groups, methods, kernel, sides):
    """The fastest peer, over the fastest kernel of those that are called so."""
    own = [method for method in methods if method.startswith(kernel) and method.endswith(sides)]
    peers = [method for method in methods if method.startswith(PEERS) and method.endswith(sides)]
    least = min(min(results[group, method]["ns"] for method in peers) / min(results[group, method]["ns"] for method in own)
                for group in groups)
    what = "the fastest kernel" if kernel == "batch" else kernel
    return Goal(f"fastest peer over {what}, {sides}", 1, least, at_least=True)
