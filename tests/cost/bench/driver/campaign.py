"""Campaigns: what workers gain, how many tasks a manager can give out, and a campaign of very many shards."""
import json
import socket
import subprocess
import tempfile
import time
from pathlib import Path

from driver import tables

CLAIMS = ["1:1e3"], ["1:3e5", "--gap", "1e-9"], ["1:3e6", "--gap", "1e-9"]


def campaign(bin_folder, effort, repeat):
    return {"workers": workers(bin_folder, effort.of(*CLAIMS), repeat), "tasks": tasks(bin_folder, effort),
            "simulated": simulated(bin_folder, effort.of(100, 1000, 100_000))}, []


def ask(*words):
    return json.loads(subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, check=True, text=True).stdout)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def local(program, folder, count):
    return ask(program, "campaign", "run", folder, "--jobs", count, "--json")


def looked_at(program, folder, count):
    """The same, but what comes in is only looked at."""
    return on_workers(program, folder, count, "--verify", "merge")


def on_workers(program, folder, count, *options):
    """A run with this number of workers of one core each, which are there from the first moment."""
    port = free_port()
    with subprocess.Popen([program, "campaign", "run", folder, "--engine", "workqueue", "--port", str(port), "--json", *options],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as manager:
        while not (folder / "password").exists():
            time.sleep(0.01)
        command = ["work_queue_worker", "--password", folder / "password", "--cores", "1", "--timeout", "30", "--workdir",
                   folder.parent, "127.0.0.1", str(port)]
        started = [subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for _ in range(count)]
        answer = json.loads(manager.stdout.read())
    for worker in started:
        worker.kill()
        worker.wait()
    return answer


def workers(bin_folder, claim, repeat):
    program = bin_folder / "dumbbell"
    ways = {(engine, count): run for engine, run in {"threads": local, "workers": on_workers, "workers --verify merge": looked_at}.items()
            for count in (1, 2)}
    found = {way: [] for way in ways}
    for _ in range(repeat):
        for (engine, count), run in ways.items():
            with tempfile.TemporaryDirectory() as scratch:
                folder = Path(scratch) / "campaign"
                subprocess.run([program, "campaign", "plan", folder, *claim], stdout=subprocess.DEVNULL, check=True)
                found[engine, count].append(run(program, folder, count))
    best = {way: min(runs, key=lambda run: run["seconds"]) for way, runs in found.items()}
    base = best["threads", 1]["seconds"]
    rows = [[f"{count} {engine}", tables.time(run["seconds"]), tables.time(run["worked_seconds"]),
             tables.time(run["verification_seconds"]), f"{1000 * run['manager_seconds_a_shard']:.1f} ms",
             tables.ratio(base / (count * run["seconds"]))] for (engine, count), run in best.items()]
    tables.show(f"A campaign: {' '.join(claim)}", ["engine", "wall", "proving", "verifying", "manager/shard", "efficiency"], rows,
                ["efficiency: wall time of one thread over (number * wall time); the best of the runs",
                 "What comes from workers is verified as it comes, on the same two cores here."])
    return [{"engine": engine, "count": count, **run} for (engine, count), run in best.items()]


def tasks(bin_folder, effort):
    sizes = effort.of([(10, "0", 8)], [(200, "0", 8), (400, "0.1", 32)], [(2000, "0", 8), (2000, "0.1", 32), (2000, "1", 200)])
    results = [ask(bin_folder / "bench_campaign", "tasks", *size) for size in sizes]
    tables.show("Tasks that only sleep", ["sleep", "at a time", "tasks", "tasks/s", "manager/task", "manager's limit"],
                [[f"{r['sleep_seconds']} s", r["worker_cores"], str(r["tasks"]), tables.rate(r["tasks_a_second"]),
                  f"{r['manager_ms_a_task']:.2f} ms", tables.rate(r["manager_limit_tasks_a_second"]) + "/s"] for r in results],
                ["manager's limit: tasks over the time that the manager itself was busy"])
    return results


def simulated(bin_folder, shards):
    r = ask(bin_folder / "bench_campaign", "simulated", shards)
    tables.show(f"A simulated campaign of {shards:,} shards, with misfortunes",
                ["workers lost", "garbage", "rejected", "split", "programs", "run", "manager/shard", "merge", "memory"],
                [[str(r["workers_lost"]), str(r["garbage"]), str(r["rejected"]), str(r["split"]), str(r["programs"]),
                  f"{r['run_seconds']:.0f} s", f"{r['manager_ms_a_shard']:.2f} ms", f"{r['merge_seconds']:.0f} s",
                  tables.memory(r["peak_megabytes"])]],
                [f"{r['accepted']:,} results accepted of {r['parts']:,} parts; merged: {'yes' if r['merged'] else 'NO'}; "
                 f"the whole verified: {'yes' if r.get('verified') else 'NO'}",
                 "Results are only looked at on arrival and when merged (--verify merge, --unverified)."])
    return r
