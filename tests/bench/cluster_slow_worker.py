"""Measures how much a worker that is 20 times slower than the others delays a run. It compares the
wall time of a coordinator and a worker of one thread each with and without such a worker, in turn
and several times. Fails if the digests differ. The ratio must be below 1.3 on an otherwise idle
machine with three cores.

    CAMBRIAN=build/release/bin/cambrian FAULTY_PROGRAM=build/release/bin/faulty_program \\
        python3 -B tests/bench/cluster_slow_worker.py --population 300 --generations 8 --times 3
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))

from experiment_tables import digests  # noqa: E402
from nats_server import NatsServer  # noqa: E402
from program import CAMBRIAN, FAULTY_PROGRAM, ROOT  # noqa: E402


def start_worker(program, server, name):
    return subprocess.Popen(
        [program, "worker", server.url, "--threads", "1", "--name", name],
        stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        env=dict(os.environ, CAMBRIAN_FAULT="slow"))


def seconds_of_run(asked, folder, name, slow):
    """Returns the wall time of all generations but the first ones, in which workers join."""
    server = NatsServer(folder / f"server-{name}")
    workers = [start_worker(CAMBRIAN, server, "worker")]
    if slow:
        workers.append(start_worker(FAULTY_PROGRAM, server, "slow"))
    out = folder / f"{name}.cambrian"
    run = subprocess.Popen(
        [CAMBRIAN, "evolve", asked.settings, "--json", "--out", out, "--threads", "1",
         "--generations", str(asked.generations), "--set", f"population.size={asked.population}",
         *asked.set, "--cluster", server.url],
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        encoding="utf-8", bufsize=1)
    times = []
    while len(times) < asked.generations:
        if not run.stdout.readline():
            raise SystemExit(f"{name}: the run failed")
        times.append(time.monotonic())
    run.communicate()
    for worker in workers:
        worker.kill()
        worker.wait(30)
    server.kill()
    return times[-1] - times[asked.skip], digests(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--settings", default=str(ROOT / "assets/settings/walking.toml"))
    parser.add_argument("--population", type=int, default=300)
    parser.add_argument("--generations", type=int, default=8)
    parser.add_argument("--skip", type=int, default=2, help="first generations that do not count")
    parser.add_argument("--times", type=int, default=3)
    parser.add_argument("--set", nargs="*", default=[], help="further options of cambrian evolve")
    asked = parser.parse_args()
    ratios = []
    with tempfile.TemporaryDirectory(prefix="cambrian-slow-") as folder:
        for i in range(asked.times):
            without, expected = seconds_of_run(asked, pathlib.Path(folder), f"without{i}", False)
            slowed, found = seconds_of_run(asked, pathlib.Path(folder), f"with{i}", True)
            if found != expected:
                raise SystemExit("the digests differ")
            print(f"  without {without:6.2f} s, with {slowed:6.2f} s", flush=True)
            ratios.append(slowed / without)
    print(f"{asked.population} creatures: wall time x {statistics.median(ratios):.3f} "
          f"(median of {asked.times})")


if __name__ == "__main__":
    main()
