"""Operations and bounces: what Google Benchmark measures, as ratios to plain double in the same run."""
from driver import google, tables
from driver.goals import Goal

# The best that can be written for one ray with libm, not the shortest: "plain double, libm" starts each contact afresh.
PLAIN = "plain double, warm"
# The general count over plain double that, like it, finds each contact by itself.
AFRESH, GENERAL, MOST = "plain double, libm", "Interval, one-sided", 1.6
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
        "one-sided: an upper bound of the count; at least: a lower bound; two-sided: both. `plain double` proves nothing, all others do.",
        "Interval, BigInterval, CGAL, Arb: the count of src/flight, the same template for all of them."])
    goals = [Goal(f"bounce, {GENERAL}, over {AFRESH}, {group}", MOST, results[group, GENERAL]["ns"] / results[group, AFRESH]["ns"])
             for group in groups]
    return as_json(results), goals + [beaten(results, groups, methods, sides) for sides in ("one-sided", "two-sided")]


def beaten(results, groups, methods, sides):
    """The fastest peer over Interval."""
    peers = [method for method in methods if method.startswith(PEERS) and method.endswith(sides)]
    least = min(min(results[group, method]["ns"] for method in peers) / results[group, f"Interval, {sides}"]["ns"] for group in groups)
    return Goal(f"fastest peer over Interval, {sides}", 1, least, at_least=True)
