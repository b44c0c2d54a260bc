"""Runs a cluster for a given time. One coordinator has one long run, another has run after run; one
worker stays while others join and leave, and the server is killed in the first quarter. Fails if
the memory of the server, the long run or the worker grows by more than 5 % from the second quarter
of the time to the last, on average. A server keeps the latest messages of each stream, up to 8 MB,
for the next seconds, so all other programs are held for some seconds before each look. It collects
its garbage often, since the collector's own tables follow the largest heap there ever was. Its garbage
and the free pages of its heap, which go back to the system slowly, do not count. Also fails if a
run's digests differ from those of one machine, or if the streams are not empty at the end.

    CAMBRIAN=build/release/bin/cambrian python3 -B tests/cli/cluster_soak.py --minutes 30
"""

import argparse
import os
import random
import re
import signal
import socket
import statistics
import subprocess
import sys
import time
import unittest
import urllib.request

from cluster_program import ClusterTest
from experiment_tables import digests
from nats_server import HOST

GENERATIONS = 60  # of a short run, which lasts about a minute on a core that is shared
SETTINGS = """
[run]
generations = {}
[population]
size = 160
[trial]
duration = {}
"""
SHORT_TRIAL = 15  # s; cheap creatures make many messages
LONG_TRIAL = 60  # s; a run keeps the champion of each generation, so the long one has few
COMPARED = 10  # generations of the long run
MINUTES = 30.0
PAUSE = 5.0  # s between two changes of the cluster
CHANGES = 8  # between two looks at the processes
FORGETS = 11.0  # s; the server keeps messages of a stream for 5 to 10 s after the last one
GROWTH = 1.05
NAMES = ("the server", "the long run", "the worker")


def free_port():
    with socket.socket() as it:
        it.bind((HOST, 0))
        return it.getsockname()[1]


def memory_of_server(port):
    """Has a server collect its garbage. Returns the memory that it uses then by its own account: what
    lives in its heap, and what is not heap (Go's runtime.MemStats). Buffers kept for reuse are only
    garbage to the second collection (Go's sync.Pool)."""
    url = f"http://{HOST}:{port}/debug/pprof/heap?gc=1&debug=1"
    for _ in range(2):
        with urllib.request.urlopen(url, timeout=30) as answer:
            found = dict(re.findall(r"# (\w+) = (\d+)", answer.read().decode()))
    return int(found["Sys"]) - int(found["HeapSys"]) + int(found["HeapAlloc"])


class Soak(ClusterTest):
    def test_memory_stays_flat_and_streams_are_left_empty(self):
        chance = random.Random(1)
        settings = SETTINGS.format(GENERATIONS, SHORT_TRIAL)
        expected = self.local_digests(settings, GENERATIONS)
        profiles = free_port()
        os.environ["GOGC"] = "10"  # %; the server collects whenever its heap has grown by so much
        server = self.start_server(f"prof_port: {profiles}\n")
        steady = self.start_worker(server.url, "steady")
        endless = SETTINGS.format(1_000_000, LONG_TRIAL)
        long = self.evolve_beside("long", server, endless)
        run, passing, samples, finished, changes = None, [], [], 0, 0
        begun = time.monotonic()
        end = begun + 60 * MINUTES
        outages = [begun + 60 * MINUTES * share for share in (0.08, 0.16)]
        while time.monotonic() < end:
            if run and run.poll() is not None:
                self.assertEqual(run.returncode, 0, run.log.read_text())
                self.assertEqual(digests(self.folder / "short.cambrian"), expected)
                run, finished = None, finished + 1
            if not run:
                (self.folder / "short.cambrian").unlink(missing_ok=True)
                run = self.evolve_beside("short", server, settings)
            if chance.random() < 0.2 and len(passing) < 2:
                passing.append(self.start_worker(server.url, "passing"))
            elif chance.random() < 0.2 and passing:
                passing.pop(0).kill()
            if outages and time.monotonic() > outages[0]:
                server.kill()
                time.sleep(5)
                server.start()
                outages.pop(0)
            time.sleep(PAUSE)
            for each in (long, steady):
                self.assertIsNone(each.poll(), f"ended by itself: {each.log.read_text()}")
            changes += 1
            if changes % CHANGES == 0:
                samples.append(self.quiet_memory(profiles, long, steady))
        self.interrupt(run)
        self.report(samples, finished, time.monotonic() - begun)
        self.end_and_compare(long, "long", endless, COMPARED)
        time.sleep(1)
        client = server.client()
        self.assertEqual(client.messages_in("cambrian-WORK"), 0)
        self.assertEqual(client.messages_in("cambrian-RESULT"), 0)
        client.close()
        quarter = len(samples) // 4
        for which, name in enumerate(NAMES):
            early = statistics.fmean(sample[which] for sample in samples[quarter:2 * quarter])
            late = statistics.fmean(sample[which] for sample in samples[-quarter:])
            self.assertLess(late, early * GROWTH, name)

    def signal_all(self, what):
        for process in self.processes:
            process.send_signal(what)

    def quiet_memory(self, profiles, *processes):
        """Holds all programs but the server until it needs no memory for what they send. Returns the
        memory of the server and of these processes."""
        self.signal_all(signal.SIGSTOP)
        time.sleep(FORGETS)
        memory = [memory_of_server(profiles), *map(self.resident_memory, processes)]
        self.signal_all(signal.SIGCONT)
        return memory

    def evolve_beside(self, name, server, settings):
        """Starts a run whose lines nobody reads; a pipe would be full after some generations."""
        return self.evolve(name, "--cluster", server.url, settings=settings,
                           stdout=subprocess.DEVNULL)

    @staticmethod
    def report(samples, finished, seconds):
        """Prints the average memory of each twelfth of the time."""
        print(f"{seconds / 60:.1f} min, {finished} short runs; MB of {', '.join(NAMES)}:")
        for twelfth in range(12):
            part = samples[twelfth * len(samples) // 12:(twelfth + 1) * len(samples) // 12]
            print("  ", " ".join(f"{statistics.fmean(values) / 1e6:7.1f}" for values in zip(*part)))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=MINUTES)
    parser.add_argument("--generations", type=int, default=GENERATIONS,
                        help="of each short run")
    asked, rest = parser.parse_known_args()
    MINUTES = asked.minutes
    GENERATIONS = asked.generations
    unittest.main(argv=[sys.argv[0], *rest])
