"""Measures the overhead of a cluster. It runs the same evolution on N threads of one machine, and
with a coordinator of one thread and a worker of N-1 on this machine, in turn and several times.
Prints the ratios of wall time and of processor time (of coordinator, worker and server together),
and fails if the digests differ. Workers have low priority, so wall times need an otherwise idle
machine; processor times do not.

    CAMBRIAN=build/release/bin/cambrian python3 -B tests/bench/cluster_overhead.py \\
        --settings assets/settings/walking.toml --population 300 --generations 6 --times 3
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
from program import CAMBRIAN, ROOT  # noqa: E402


def processor_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Measurement:
    def __init__(self, asked, folder):
        self.asked = asked
        self.folder = folder
        self.server = NatsServer(folder / "server")
        self.worker = subprocess.Popen(
            [CAMBRIAN, "worker", self.server.url, "--threads", str(asked.threads - 1)],
            stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def close(self):
        self.worker.terminate()
        self.worker.wait(30)
        self.server.kill()

    def others(self):
        return processor_seconds(self.server.process.pid) + processor_seconds(self.worker.pid)

    def run(self, name, threads, *options):
        """Returns wall and processor time of all generations but the first, in which workers
        join."""
        out = self.folder / f"{name}.cambrian"
        out.unlink(missing_ok=True)
        run = subprocess.Popen(
            [CAMBRIAN, "evolve", self.asked.settings, "--json", "--out", out, "--threads",
             str(threads), "--generations", str(self.asked.generations), "--set",
             f"population.size={self.asked.population}", *self.asked.set, *options],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            encoding="utf-8", bufsize=1)
        times = []
        while len(times) < self.asked.generations:
            if not run.stdout.readline():
                raise SystemExit(f"{name}: the run failed")
            times.append((time.monotonic(), processor_seconds(run.pid) + self.others()))
        run.communicate()
        skipped = self.asked.skip
        return [times[-1][i] - times[skipped][i] for i in (0, 1)], digests(out)


def ratios(measurement):
    threads = measurement.asked.threads
    alone, expected = measurement.run("alone", threads)
    shared, found = measurement.run("shared", 1, "--cluster", measurement.server.url)
    if found != expected:
        raise SystemExit("the digests differ")
    print(f"  alone {alone[0]:6.2f} s wall {alone[1]:6.2f} s processor, on the cluster "
          f"{shared[0]:6.2f} s wall {shared[1]:6.2f} s processor", flush=True)
    return [shared[i] / alone[i] for i in (0, 1)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--settings", default=str(ROOT / "assets/settings/walking.toml"))
    parser.add_argument("--population", type=int, default=300)
    parser.add_argument("--generations", type=int, default=8)
    parser.add_argument("--skip", type=int, default=1, help="first generations that do not count")
    parser.add_argument("--threads", type=int, default=2, help="in all, at least 2")
    parser.add_argument("--times", type=int, default=3)
    parser.add_argument("--set", nargs="*", default=[], help="further options of cambrian evolve")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="cambrian-overhead-") as folder:
        measurement = Measurement(asked, pathlib.Path(folder))
        try:
            found = [ratios(measurement) for _ in range(asked.times)]
        finally:
            measurement.close()
    wall, processor = (statistics.median(each[i] for each in found) for i in (0, 1))
    print(f"{asked.population} creatures, {asked.threads} cores: wall time x {wall:.3f}, "
          f"processor time x {processor:.3f} (medians of {asked.times})")


if __name__ == "__main__":
    main()
