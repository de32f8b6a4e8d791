"""Runs a Google Benchmark program of this folder."""
import json
import subprocess


def run(program, repetitions, least_seconds):
    """{(group, method): the least nanoseconds of CPU time of one operation} for benchmarks that are called "KIND/GROUP/METHOD".

    The repetitions of all benchmarks are interleaved at random, so that what else the machine does hits all of them alike; CPU
    time, not wall time, for the same reason."""
    done = subprocess.run(
        [program, "--benchmark_format=json", f"--benchmark_repetitions={repetitions}", f"--benchmark_min_time={least_seconds}",
         "--benchmark_enable_random_interleaving=true"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{program} failed: {done.stderr.strip()}")
    samples = {}
    # Back into the order of the program.
    for one in sorted(json.loads(done.stdout)["benchmarks"], key=lambda one: one["family_index"]):
        if one["run_type"] != "iteration":
            continue
        if one["time_unit"] != "ns":
            raise RuntimeError(f"{program}: unit {one['time_unit']}")
        _, name = one["run_name"].split("/", 1)
        group, method = name.rsplit("/", 1)  # a group may be called "/": the division
        samples.setdefault((group, method), []).append(one["cpu_time"] / one["operations"])
    return {key: min(values) for key, values in samples.items()}
