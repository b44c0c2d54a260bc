"""Runs a cluster for a given time. One coordinator has one long run, another has run after run; one
worker stays while others join and leave, and the server is killed in the first quarter. Fails if
the memory of the server, the long run or the worker grows by more than 5 % from the second quarter
of the time to the last. The lowest memory of each quarter counts, and the server collects its
garbage often, since a garbage collector uses more at times. Also fails if a run's digests differ
from those of one machine, or if the streams are not empty at the end.

    CAMBRIAN=build/release/bin/cambrian python3 -B tests/cli/cluster_soak.py --minutes 30
"""

import argparse
import os
import random
import subprocess
import sys
import time
import unittest

from cluster_program import ClusterTest
from experiment_tables import digests

GENERATIONS = 60  # of a short run, which lasts about a minute on a core that is shared
SETTINGS = """
[run]
generations = {}
[population]
size = 40
[trial]
duration = 60
"""
MINUTES = 30.0
PAUSE = 5.0  # s between two looks at the processes
GROWTH = 1.05


class Soak(ClusterTest):
    def test_memory_stays_flat_and_streams_are_left_empty(self):
        os.nice(19)
        os.environ["GOGC"] = "10"  # the server collects when its memory has grown by a tenth
        chance = random.Random(1)
        settings = SETTINGS.format(GENERATIONS)
        expected = self.local_digests(settings)
        server = self.start_server()
        steady = self.start_worker(server.url, "steady")
        endless = SETTINGS.format(1_000_000)
        # The lines go to a file, since a pipe without a reader would be full after some
        # generations.
        long = self.evolve("long", "--cluster", server.url, settings=endless,
                           stdout=subprocess.DEVNULL)
        run, passing, samples, finished = None, [], [], 0
        begun = time.monotonic()
        end = begun + 60 * MINUTES
        outages = [begun + 60 * MINUTES * share for share in (0.08, 0.16)]
        while time.monotonic() < end:
            if run and run.poll() is not None:
                self.finish(run)
                self.assertEqual(digests(self.folder / "short.cambrian"), expected)
                run, finished = None, finished + 1
            if not run:
                (self.folder / "short.cambrian").unlink(missing_ok=True)
                run = self.evolve("short", "--cluster", server.url, settings=settings)
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
            samples.append([self.resident_memory(each) for each in (server.process, long, steady)])
        for each in (run, long):
            self.interrupt(each)
        self.report(samples, finished, time.monotonic() - begun)
        self.assertEqual(digests(self.folder / "long.cambrian")[:len(expected)], expected)
        time.sleep(1)
        client = server.client()
        self.assertEqual(client.messages_in("cambrian-WORK"), 0)
        self.assertEqual(client.messages_in("cambrian-RESULT"), 0)
        client.close()
        quarter = len(samples) // 4
        for which, name in enumerate(("the server", "the long run", "the worker")):
            early = min(sample[which] for sample in samples[quarter:2 * quarter])
            late = min(sample[which] for sample in samples[-quarter:])
            self.assertLess(late, early * GROWTH, name)

    @staticmethod
    def report(samples, finished, seconds):
        print(f"{seconds / 60:.1f} min, {finished} short runs; MB of server, long run, worker:")
        for at in range(0, len(samples), max(1, len(samples) // 12)):
            print("  ", " ".join(f"{value / 1e6:7.1f}" for value in samples[at]))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=MINUTES)
    parser.add_argument("--generations", type=int, default=GENERATIONS,
                        help="of each short run")
    asked, rest = parser.parse_known_args()
    MINUTES = asked.minutes
    GENERATIONS = asked.generations
    unittest.main(argv=[sys.argv[0], *rest])
