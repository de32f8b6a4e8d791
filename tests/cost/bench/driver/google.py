"""Runs a Google Benchmark program of this folder."""
import json
import statistics
import subprocess


def run(program, repetitions, least_seconds, kind=""):
    """{(group, method): {"ns": median CPU time of one operation, ...}} for benchmarks that are called "KIND/GROUP/METHOD"; of one kind, if asked for.

    The repetitions of all benchmarks are interleaved at random, so that what else the machine does hits all of them alike; CPU
    time, not wall time, for the same reason."""
    done = subprocess.run(
        [program, f"--benchmark_filter=^{kind}", "--benchmark_format=json", f"--benchmark_repetitions={repetitions}", f"--benchmark_min_time={least_seconds}",
         "--benchmark_enable_random_interleaving=true"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{program} failed: {done.stderr.strip()}")
    samples, counters = {}, {}
    # Back into the order of the program.
    for one in sorted(json.loads(done.stdout)["benchmarks"], key=lambda one: one["family_index"]):
        if one["run_type"] != "iteration":
            continue
        if one["time_unit"] != "ns":
            raise RuntimeError(f"{program}: unit {one['time_unit']}")
        _, name = one["run_name"].split("/", 1)
        group, method = name.rsplit("/", 1)  # a group may be called "/": the division
        samples.setdefault((group, method), []).append(one["cpu_time"] / one["operations"])
        counters[group, method] = {name: one[name] for name in ("operations", "agreeing") if name in one}
    return {key: {"ns": statistics.median(values), "samples": len(values), **counters[key]} for key, values in samples.items()}

