"""Faults with a real server: a network that is cut, and workers with the faults of faulty_program.
Every run must have the bits of the run on one thread."""

import json
import os
import signal
import time
import unittest

from cluster_program import ClusterTest
from experiment_tables import digests
from network_cut import CuttableNetwork
from program import DONE, FAILED, FAULTY_PROGRAM

# Time in s for which a network is cut; 30 s would be realistic but too long for a test.
CUT_SECONDS = float(os.environ.get("CAMBRIAN_CUT_SECONDS", 4))

# A generation takes about half a second on a core, and the run lasts longer than any test.
ENDLESS = """
[run]
generations = 10000
[population]
size = 60
[trial]
duration = 60
"""

GIVEN_UP = "$JS.EVENT.ADVISORY.CONSUMER.MAX_DELIVERIES.cambrian-WORK.workers"

MOST_GENERATIONS = 20  # that a test waits for


class FaultTest(ClusterTest):
    def start_faulty(self, url, fault):
        return self.start("worker", url, "--name", fault, program=FAULTY_PROGRAM,
                          env={"CAMBRIAN_FAULT": fault})

    def evolve(self, name, *options, **more):
        """Starts a run whose output goes to a file, so that it never waits for a reader."""
        with open(self.folder / f"{name}.json", "wb") as lines:
            run = super().evolve(name, *options, stdout=lines, **more)
        run.lines = open(self.folder / f"{name}.json", encoding="utf-8")
        self.addCleanup(run.lines.close)
        return run

    def finish(self, run, seconds=240):
        self.assertEqual(run.wait(seconds), DONE, run.log.read_text())

    def next_generation(self, run, seconds=240):
        end = time.monotonic() + seconds
        line = ""
        while time.monotonic() < end:
            line += run.lines.readline()
            if line.endswith("\n"):
                return json.loads(line)
            time.sleep(0.02)
        self.fail(run.log.read_text())

    def generations_until(self, run, wanted):
        """Returns the generations up to the first for which the condition holds."""
        found = []
        while len(found) < MOST_GENERATIONS:
            found.append(self.next_generation(run))
            if wanted(found[-1]["cluster"]):
                return found
        self.fail(f"it did not happen: {found}")

    def deliver_again_after(self, server, seconds):
        """Shortens the server's time until a message is delivered again."""
        client = server.client()
        about = client.request("$JS.API.CONSUMER.INFO.cambrian-WORK.workers")["config"]
        about["ack_wait"] = int(seconds * 1e9)
        changed = client.request(
            "$JS.API.CONSUMER.DURABLE.CREATE.cambrian-WORK.workers",
            json.dumps({"stream_name": "cambrian-WORK", "config": about}).encode())
        self.assertNotIn("error", changed)
        client.close()

    def messages_of(self, server, *subjects):
        """Returns a client that receives these messages from now on."""
        client = server.client()
        for number, subject in enumerate(subjects, 1):
            client.subscribe(subject, number)
        client.flush()
        self.addCleanup(client.close)
        return client

    @staticmethod
    def hear(client, wanted, seconds):
        """Returns the first message for which the condition holds, None if none comes in time."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for subject, body in client.flush()[1]:
                if wanted(subject, body):
                    return subject, body
            time.sleep(0.02)
        return None

    def wait_to_hear(self, client, wanted, seconds=120):
        message = self.hear(client, wanted, seconds)
        self.assertIsNotNone(message, "it was not heard")
        return message


class Cuts(FaultTest):
    """One of two workers is connected through a network that is cut for some seconds."""

    def setUp(self):
        super().setUp()
        self.server = self.start_server()
        self.network = CuttableNetwork(self.server.port)
        self.addCleanup(self.network.close)
        self.start_worker(self.server.url, "near")
        self.far = self.start_worker(self.network.url, "far")
        self.run_there = self.evolve("cut", "--cluster", self.server.url, settings=ENDLESS)
        workers = self.wait_for_workers(self.server.url, 2)
        self.ids = {each["name"]: each["id"].encode() for each in workers}

    def results(self):
        return self.messages_of(self.server, "cambrian.result.>")

    def wait_for_far(self, results):
        self.wait_to_hear(results, lambda _, body: self.ids["far"] in body)

    def end_run(self):
        self.assertIsNone(self.far.poll(), self.far.log.read_text())
        self.end_and_compare(self.run_there, "cut", ENDLESS)
        self.assertNotIn("is refused", self.run_there.log.read_text())

    def test_a_run_does_not_wait_for_a_worker_whose_network_is_cut(self):
        results = self.results()
        self.wait_for_far(results)
        self.network.cut()
        repaired = time.monotonic() + CUT_SECONDS
        for _ in range(3):
            self.next_generation(self.run_there)
        time.sleep(max(0.0, repaired - time.monotonic()))
        self.network.repair()
        self.wait_for_far(self.results())
        self.end_run()

    def test_late_results_of_a_network_that_was_cut_are_compared(self):
        """The coordinator is stopped meanwhile, so that its generation does not end."""
        self.wait_for_results(self.server)
        self.deliver_again_after(self.server, 3)
        counts = {}
        for _ in range(MOST_GENERATIONS):
            self.wait_for_far(self.results())
            self.network.cut()
            self.run_there.send_signal(signal.SIGSTOP)
            results = self.results()
            self.wait_until_all_is_answered()
            self.network.repair()
            self.hear(results, lambda _, body: self.ids["far"] in body, 10)
            self.run_there.send_signal(signal.SIGCONT)
            counts = self.next_generation(self.run_there)["cluster"]
            self.assertEqual(counts["refused"], 0)
            if counts["duplicates"] > 0:
                break
        self.assertGreater(counts["duplicates"], 0)
        self.end_run()

    def wait_until_all_is_answered(self):
        """Waits until the units of the far worker were delivered to the near one."""
        client = self.server.client()
        end = time.monotonic() + 120
        left = 1
        while left and time.monotonic() < end:
            time.sleep(0.1)
            left = client.messages_in("cambrian-WORK")
        client.close()
        self.assertEqual(left, 0)


class Faults(FaultTest):
    def test_nobody_waits_for_a_worker_that_is_twenty_times_slower(self):
        server = self.start_server()
        self.start_worker(server.url)
        self.start_faulty(server.url, "slow")
        run = self.evolve("slow", "--cluster", server.url, settings=ENDLESS)
        self.generations_until(run, lambda counts: counts["overdue_at_home"] > 0)
        self.end_and_compare(run, "slow", ENDLESS)

    def test_a_worker_that_flips_bits_is_refused(self):
        server = self.start_server()
        self.start_worker(server.url)
        faulty = self.start_faulty(server.url, "flips")
        run = self.evolve("flips", "--cluster", server.url, settings=ENDLESS)
        self.wait_for_message(run, "flips is refused: a result differed", 120)
        self.wait_for_message(faulty, "refuses this worker: a result differed")
        self.assertIsNone(faulty.poll())
        self.end_and_compare(run, "flips", ENDLESS)

    def test_a_unit_that_is_never_acknowledged_is_deleted(self):
        """The coordinator is stopped meanwhile; otherwise it would compute the unit itself."""
        server = self.start_server()
        self.start_faulty(server.url, "silent")
        run = self.evolve("silent", "--cluster", server.url, settings=ENDLESS)
        given_up = self.messages_of(server, GIVEN_UP)
        deleted = self.messages_of(server, "$JS.API.STREAM.MSG.DELETE.cambrian-WORK")
        work = self.messages_of(server, "cambrian.work.>")
        self.wait_to_hear(work, lambda *_: True)
        self.deliver_again_after(server, 0.1)
        self.assertTrue(any(self.deletes_what_is_given_up(run, work, given_up, deleted)
                            for _ in range(MOST_GENERATIONS)))
        self.end_and_compare(run, "silent", ENDLESS)
        after = server.client()
        self.assertEqual(after.messages_in("cambrian-WORK"), 0)
        self.assertEqual(after.messages_in("cambrian-RESULT"), 0)
        after.close()

    def deletes_what_is_given_up(self, run, work, given_up, deleted):
        """Returns false if the generation ended first, which withdraws all its units."""
        self.wait_to_hear(work, lambda *_: True)
        run.send_signal(signal.SIGSTOP)
        sequence = self.hear(given_up, lambda *_: True, 20)
        run.send_signal(signal.SIGCONT)
        if sequence is None:
            return False
        wanted = json.loads(sequence[1])["stream_seq"]
        return self.hear(deleted, lambda _, body: json.loads(body)["seq"] == wanted, 5) is not None

    def test_a_genome_that_ends_its_workers_is_found_and_written_down(self):
        server = self.start_server()
        run = self.evolve("dies", "--cluster", server.url, settings=ENDLESS,
                          program=FAULTY_PROGRAM, env={"CAMBRIAN_FAULT": "dies"})
        self.next_generation(run)
        workers = [self.start_faulty(server.url, "dies") for _ in range(2)]
        self.assertEqual(run.wait(240), FAILED, run.log.read_text())
        self.assertIn(-signal.SIGABRT, [worker.poll() for worker in workers])
        file = f"crash-{(self.folder / 'poison').read_text()}.creature.json"
        self.assertIn(f"the genome in {file} ends the process that evaluates it (signal 6",
                      run.log.read_text())
        self.run_well("simulate", file)
        found = digests(self.folder / "dies.cambrian")
        self.assertGreater(len(found), 0)
        self.assertEqual(found, self.local_digests(ENDLESS, len(found)))

    def test_a_process_of_its_own_that_refuses_is_no_crash(self):
        server = self.start_server()
        run = self.evolve("refuses", "--cluster", server.url, settings=ENDLESS,
                          program=FAULTY_PROGRAM, env={"CAMBRIAN_FAULT": "refuses"})
        self.start_faulty(server.url, "silent")
        self.wait_for_message(run, "a process of its own did not compute a unit (exit status 2): "
                                   "cambrian: not today", 120)
        self.generations_until(run, lambda counts: counts["poisoned"] > 0)
        self.end_and_compare(run, "refuses", ENDLESS)


if __name__ == "__main__":
    unittest.main()
