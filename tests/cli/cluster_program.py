"""A cluster of real processes on this machine: a server, workers, and runs that use them."""

import json
import os
import pathlib
import signal
import subprocess
import time

from experiment_tables import digests
from kept_runs import digests_of_run
from nats_server import PLAIN, NatsServer
from program import CAMBRIAN, ProgramTest

GENERATIONS = 8

# The run lasts some seconds on a core, long enough for workers to join.
SETTINGS = f"""
[run]
generations = {GENERATIONS}
[population]
size = 60
[trial]
duration = 12
"""


class ClusterTest(ProgramTest):
    """Each test has its own server; all processes end with the test."""

    def setUp(self):
        super().setUp()
        self.processes = []
        self.addCleanup(self.end_processes)

    def start_server(self, configuration=PLAIN, **options):
        server = NatsServer(self.folder / "server", configuration, **options)
        self.addCleanup(server.kill)
        return server

    def end_processes(self):
        for process in self.processes:
            self.end(process)

    def start(self, *arguments, program=CAMBRIAN, **options):
        """Starts a process of the program; its messages go to a file."""
        environment = dict(os.environ, **options.pop("env", {}))
        options.setdefault("stdout", subprocess.PIPE)
        number = len(self.processes)
        log = self.folder / f"process{number}.log"
        with open(log, "wb") as messages:
            process = subprocess.Popen(
                [program, *map(str, arguments)], cwd=self.folder, env=environment,
                stdin=subprocess.DEVNULL, stderr=messages, encoding="utf-8", **options)
        process.log = log
        self.processes.append(process)
        return process

    def start_worker(self, url, name="worker", *options, **more):
        """The worker has normal priority, so that other tests do not starve it."""
        return self.start("worker", url, "--threads", 1, "--name", name, "--priority", "normal",
                          *options, **more)

    def wait_for_workers(self, url, count, *options):
        """Waits until so many workers announce themselves."""
        end = time.monotonic() + 30
        while time.monotonic() < end:
            lines = self.run_well("cluster", url, "--json", *options).stdout.splitlines()
            workers = [each for each in map(json.loads, lines) if each["role"] == "worker"]
            if len(workers) >= count:
                return workers
        self.fail(f"{count} workers did not appear")

    def wait_for_message(self, process, text, seconds=30):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if text in process.log.read_text():
                return
            time.sleep(0.02)
        self.fail(f"'{text}' was not said: {process.log.read_text()}")

    def listen(self, client, heard, count):
        """Returns what was heard, at least `count` times, of the messages that arrive."""
        found = []
        end = time.monotonic() + 60
        while len(found) < count and time.monotonic() < end:
            client.flush()
            found += heard()
            time.sleep(0.02)
        client.close()
        self.assertGreaterEqual(len(found), count, "too few messages arrived")
        return found

    def wait_for_results(self, server, count=1):
        """Waits until workers have sent so many more results."""
        client = server.client()
        client.subscribe("cambrian.result.>")
        self.listen(client, lambda: client.messages, count)

    def interrupt(self, process, seconds=30):
        process.send_signal(signal.SIGINT)
        return process.wait(seconds)

    # -- runs

    def evolve(self, name, *options, settings=SETTINGS, **more):
        """Starts a run; its settings are <name>.toml, its experiment file <name>.cambrian."""
        self.write(f"{name}.toml", settings)
        return self.start("evolve", f"{name}.toml", "--out", f"{name}.cambrian", "--threads", 1,
                          "--json", *options, **more)

    def finish(self, run, seconds=240):
        """Returns the lines of the generations of a run that ends successfully."""
        text, _ = run.communicate(timeout=seconds)
        self.assertEqual(run.returncode, 0, run.log.read_text())
        return [json.loads(line) for line in text.splitlines()][:-1]

    def local_digests(self, settings=SETTINGS, count=GENERATIONS):
        """Returns the digests of the first generations of the run on one machine, which every other
        run must have."""
        def compute(most):
            self.finish(self.evolve("local", "--generations", most, settings=settings))
            return digests(self.folder / "local.cambrian")

        return digests_of_run(settings, count, compute)

    def evolve_until(self, wanted, url, *options, least=1):
        """Repeats the run, which must be the one on one machine, at least so often and until the
        sums of all counts are as wanted: on a busy machine a short run may end before workers
        answer. Returns the generations of all runs."""
        expected = self.local_digests()
        generations = []
        end = time.monotonic() + 240
        number = 0
        while time.monotonic() < end:
            number += 1
            run = self.evolve(f"run{number}", "--cluster", url, *options)
            generations += self.finish(run)
            self.assert_same_run(expected, f"run{number}")
            self.assertNotIn("permit", run.log.read_text())
            if number >= least and wanted(self.sums(generations)):
                return generations
        self.fail(f"not as wanted: {self.sums(generations)}")

    def end_and_compare(self, run, name, settings, most=None):
        """Ends a long run and compares its finished generations, or so many of them, with those of
        one machine."""
        end = time.monotonic() + 60
        while len(digests(self.folder / f"{name}.cambrian")) < 2 and time.monotonic() < end:
            time.sleep(0.1)
        self.interrupt(run)
        found = digests(self.folder / f"{name}.cambrian")[:most]
        self.assertGreaterEqual(len(found), 2, run.log.read_text())
        self.assertEqual(found, self.local_digests(settings, len(found)))

    def assert_same_run(self, expected, name):
        self.assertEqual(digests(self.folder / f"{name}.cambrian"), expected)

    @staticmethod
    def sums(generations):
        """Returns the cluster's counts, summed over all generations."""
        total = {}
        for generation in generations:
            for key, value in generation["cluster"].items():
                if not isinstance(value, bool):
                    total[key] = total.get(key, 0) + value
        return total

    def resident_memory(self, process):
        """Returns the resident memory in bytes."""
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
        return next(int(line.split()[1]) * 1024 for line in status.splitlines()
                    if line.startswith("VmRSS"))
