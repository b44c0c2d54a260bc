"""Evolution on several machines: a run has the bits of the run on one thread, whoever computes
it."""

import json
import os
import random
import signal
import socket
import subprocess
import time
import unittest
import zlib

from cluster_program import ClusterTest
from nats_server import HOST

# A generation takes seconds on a core, so that it can be interrupted.
SLOW = """
[run]
generations = 6
[population]
size = 40
[trial]
duration = 60
"""

# Lasts longer than any test.
ENDLESS = SLOW.replace("generations = 6", "generations = 10000")

# Unpacks to a megabyte.
MANY_ZEROS = zlib.compress(b"0" * 1_000_000)

NOBODY_HEARD = ("no machine announces itself on this cluster; workers that wait for its first run "
                "are silent\n")


class Runs(ClusterTest):
    def test_a_cluster_without_workers_evolves_the_same_run(self):
        expected = self.local_digests()
        server = self.start_server()
        run = self.evolve("alone", "--cluster", server.url)
        generations = self.finish(run)
        self.assert_same_run(expected, "alone")
        self.assertEqual(self.sums(generations)["units"], 0)

    def test_workers_evolve_the_same_run_and_leave_nothing_behind(self):
        server = self.start_server()
        workers = [self.start_worker(server.url, f"worker {i}") for i in range(7)]
        for worker in workers:
            self.wait_for_message(worker, "waiting")
        self.assertEqual(self.run_well("cluster", server.url).stdout, NOBODY_HEARD)
        generations = self.evolve_until(
            lambda sums: sums["units"] > 12 and sums["checked"] > 0, server.url, least=2)
        sums = self.sums(generations)
        for count in ("refused", "malformed"):
            self.assertEqual(sums[count], 0, sums)
        self.assertGreater(max(each["cluster"]["machines"] for each in generations), 2)
        self.assert_streams_empty(server)
        names = {each["name"] for each in self.wait_for_workers(server.url, 7)}
        self.assertEqual(names, {f"worker {i}" for i in range(7)})
        for worker in workers:
            self.assertEqual(self.interrupt(worker), 0, worker.log.read_text())
        self.assertEqual(self.run_well("cluster", server.url).stdout, NOBODY_HEARD)

    def test_workers_that_are_killed_cost_nothing_but_time(self):
        server = self.start_server()
        workers = [self.start_worker(server.url) for _ in range(3)]
        run = self.evolve("killed", "--cluster", server.url, settings=ENDLESS)
        for _ in range(5):
            self.wait_for_results(server)
            time.sleep(0.5)
            workers[0].kill()
            workers = workers[1:] + [self.start_worker(server.url)]
        self.end_and_compare(run, "killed", ENDLESS)

    def test_a_run_goes_on_alone_while_the_server_is_gone(self):
        server = self.start_server()
        self.start_worker(server.url)
        run = self.evolve("outage", "--cluster", server.url, settings=ENDLESS)
        self.wait_for_results(server)
        server.kill()
        self.wait_for_message(run, "cluster away, working alone")
        time.sleep(1)
        server.start()
        self.wait_for_message(run, "cluster reached again")
        self.wait_for_results(server)
        self.end_and_compare(run, "outage", ENDLESS)

    def test_a_run_goes_on_alone_when_all_workers_are_gone(self):
        server = self.start_server()
        workers = [self.start_worker(server.url) for _ in range(2)]
        run = self.evolve("left", "--cluster", server.url, settings=ENDLESS)
        self.wait_for_results(server)
        for worker in workers:
            worker.kill()
        self.wait_for_message(run, "no other machine is left, working alone")
        self.end_and_compare(run, "left", ENDLESS)

    def test_a_run_that_was_killed_is_resumed_without_what_it_left(self):
        server = self.start_server()
        run = self.evolve("resumed", "--cluster", server.url, settings=ENDLESS)
        worker = self.start_worker(server.url)
        self.wait_for_results(server)
        worker.send_signal(signal.SIGSTOP)
        run.kill()
        run.wait(30)
        worker.send_signal(signal.SIGCONT)
        again = self.start("evolve", "--resume", "resumed.cambrian", "--json", "--cluster",
                           server.url, "--threads", 1)
        self.wait_for_results(server)
        self.end_and_compare(again, "resumed", ENDLESS)
        self.assert_streams_empty(server)

    def test_a_worker_that_stops_answering_costs_only_its_units(self):
        server = self.start_server()
        workers = [self.start_worker(server.url) for _ in range(2)]
        run = self.evolve("stuck", "--cluster", server.url, settings=ENDLESS)
        self.wait_for_results(server)
        workers[0].send_signal(signal.SIGSTOP)
        time.sleep(3)
        workers[0].send_signal(signal.SIGCONT)  # its late results are duplicates
        self.wait_for_results(server, 3)
        self.end_and_compare(run, "stuck", ENDLESS)

    def assert_streams_empty(self, server):
        client = server.client()
        left = {name: client.messages_in(f"cambrian-{name}") for name in ("WORK", "RESULT")}
        client.close()
        self.assertEqual(left, {"WORK": 0, "RESULT": 0})

    @unittest.skipUnless("CAMBRIAN_LONG_OUTAGES" in os.environ, "takes two minutes")
    def test_workers_are_used_again_soon_after_a_long_outage(self):
        server = self.start_server()
        self.start_worker(server.url)
        # Nobody reads its lines, and a full pipe would stop it.
        run = self.evolve("long", "--cluster", server.url, settings=ENDLESS,
                          stdout=subprocess.DEVNULL)
        for outage in (1, 10, 60):
            self.wait_for_results(server)
            server.kill()
            time.sleep(outage)
            server.start()
            begun = time.monotonic()
            self.wait_for_results(server)
            print(f"outage of {outage} s: first result {time.monotonic() - begun:.1f} s after it")
        self.interrupt(run)

    def test_two_runs_share_the_workers(self):
        expected = self.local_digests()
        server = self.start_server()
        for i in range(2):
            self.start_worker(server.url)
        runs = [self.evolve(name, "--cluster", server.url) for name in ("one", "two")]
        for run in runs:
            self.finish(run)
        self.assert_same_run(expected, "one")
        self.assert_same_run(expected, "two")

    def test_each_unit_goes_to_one_worker(self):
        server = self.start_server()
        for i in range(3):
            self.start_worker(server.url)
        client = server.client()
        client.subscribe("cambrian.result.>")
        self.evolve("shared", "--cluster", server.url, settings=ENDLESS)
        sent = self.listen(client, lambda: [subject for subject, _ in client.messages], 60)
        self.assertEqual(len(sent), len(set(sent)), sent)

    def test_runs_do_not_read_answers_of_each_other(self):
        server = self.start_server()
        self.start_worker(server.url)
        client = server.client()
        client.subscribe("cambrian.work.>")
        for name in ("one", "two"):
            self.evolve(name, "--cluster", server.url, settings=ENDLESS)
        expected = self.listen(client, lambda: client.replies, 40)
        self.assertEqual(len(expected), len(set(expected)), expected)
        inboxes = {subject.rsplit(".", 1)[0] for subject in expected}
        self.assertEqual(len(inboxes), 2, inboxes)

    def test_a_run_that_is_interrupted_leaves_nothing_behind(self):
        server = self.start_server()
        self.start_worker(server.url)
        run = self.evolve("stopped", "--cluster", server.url, settings=ENDLESS)
        self.wait_for_results(server)
        self.interrupt(run)
        client = server.client()
        self.assertEqual(client.messages_in("cambrian-WORK"), 0)
        client.close()


class Garbage(ClusterTest):
    def bodies(self, chance):
        """Returns a malformed message, chosen at random."""
        kind = chance.randrange(5)
        if kind == 0:
            return chance.randbytes(chance.randrange(200))
        if kind == 1:
            return b"[" * chance.randrange(1, 5000)
        if kind == 2:
            return MANY_ZEROS
        if kind == 3:
            return b"{\"format\": \"cambrian-unit\", \"version\": 1, \"creatures\": " + b"9" * 400
        return chance.randbytes(20_000)

    def test_ten_thousand_messages_of_garbage_harm_nobody(self):
        server = self.start_server()
        worker = self.start_worker(server.url)
        run = self.evolve("garbage", "--cluster", server.url, settings=ENDLESS)
        self.wait_for_results(server)
        before = self.resident_memory(worker)
        client = server.client()
        chance = random.Random(1)
        run_id = "%016x" % 5
        subjects = [f"cambrian.work.{run_id}.1.", f"cambrian.result.{run_id}.1.",
                    "cambrian.work.x.y.", "cambrian.result.z.", "cambrian.hello.worker.",
                    "cambrian.hello.coordinator.", "cambrian.stop.", f"cambrian.work.{run_id}."]
        for i in range(10_000):
            client.publish(chance.choice(subjects) + str(i), self.bodies(chance))
            if i % 100 == 0:
                client.flush()
        client.flush()
        time.sleep(1)
        self.assertLess(self.resident_memory(worker) - before, 64_000_000)
        self.assertIsNone(worker.poll(), worker.log.read_text())
        self.end_and_compare(run, "garbage", ENDLESS)
        client.close()

    def test_more_answers_than_a_worker_asked_for_do_not_damage_it(self):
        """The C library checks the worker's memory, and ends it if something was written beyond a
        block."""
        server = self.start_server()
        run = self.evolve("answers", "--cluster", server.url, settings=ENDLESS)
        worker = self.start("worker", server.url, "--threads", 4, "--priority", "normal",
                            env={"LD_PRELOAD": "libc_malloc_debug.so.0",
                                 "GLIBC_TUNABLES": "glibc.malloc.check=3"})
        self.wait_for_results(server)
        client = server.client()
        client.subscribe("$JS.API.CONSUMER.MSG.NEXT.cambrian-WORK.workers")
        asked = 0
        end = time.monotonic() + 60
        while asked < 20 and time.monotonic() < end:
            client.flush()
            for reply in client.replies:
                for _ in range(13):
                    client.publish(reply, b"garbage")
            asked += len(client.replies)
            time.sleep(0.01)
        client.close()
        self.assertGreaterEqual(asked, 20)
        self.wait_for_results(server)
        self.assertIsNone(worker.poll(), worker.log.read_text())
        self.end_and_compare(run, "answers", ENDLESS)


class Mistakes(ClusterTest):
    """Each mistake on the command line gives one message at once."""

    def assert_refused_by_all(self, url, *parts, options=()):
        self.write("settings.toml", "[run]\ngenerations = 1\n[population]\nsize = 6\n")
        for command in (["worker", url], ["cluster", url],
                        ["evolve", "settings.toml", "--cluster", url, "--out", "x.cambrian"]):
            result = self.run_program(*command, *options)
            self.assert_refused(result, *parts)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertNotIn("x.cambrian", self.files())

    def test_a_host_that_is_none_is_refused(self):
        self.assert_refused_by_all("nats://nowhere.invalid", "no host", "nowhere.invalid")

    def test_a_server_that_speaks_another_language_is_refused(self):
        with socket.create_server((HOST, 0)) as listener:
            listener.settimeout(60)
            port = listener.getsockname()[1]
            pid = os.fork()
            if pid == 0:
                try:
                    for _ in range(20):
                        connection, _ = listener.accept()
                        connection.sendall(b"SSH-2.0-OpenSSH_9.2\r\n")
                        connection.close()
                finally:
                    os._exit(0)
            self.addCleanup(os.waitpid, pid, 0)
            self.addCleanup(os.kill, pid, signal.SIGKILL)
            self.assert_refused_by_all(f"nats://{HOST}:{port}", "no NATS server answers at")

    def test_a_server_without_jetstream_is_refused(self):
        server = self.start_server(jetstream=False)
        self.write("settings.toml", "[run]\ngenerations = 1\n")
        for command in (["worker", server.url],
                        ["evolve", "settings.toml", "--cluster", server.url]):
            self.assert_refused(self.run_program(*command), "the server has no JetStream: start "
                                "it with -js or the sample configuration")

    def test_a_stream_with_other_settings_is_refused(self):
        server = self.start_server()
        client = server.client()
        made = client.request("$JS.API.STREAM.CREATE.cambrian-WORK", json.dumps(
            {"name": "cambrian-WORK", "subjects": ["cambrian.work.>"], "retention": "limits",
             "storage": "memory", "discard": "old", "max_bytes": 1000, "max_age": 0,
             "max_msgs": -1, "max_consumers": -1, "num_replicas": 1}).encode())
        self.assertNotIn("error", made)
        self.write("settings.toml", "[run]\ngenerations = 1\n")
        result = self.run_program("evolve", "settings.toml", "--cluster", server.url)
        self.assert_refused(result, "a stream cambrian-WORK with other settings",
                            "retention limits (expected work queue)",
                            "bytes 1000 (expected 256000000)", "--cluster-name")
        after = client.request("$JS.API.STREAM.INFO.cambrian-WORK")
        self.assertEqual(after["config"]["retention"], "limits")
        client.close()
        self.run_well("evolve", "settings.toml", "--cluster", server.url, "--cluster-name", "lab",
                      "--set", "population.size=6", "--set", "trial.duration=1")

    def test_credentials_that_are_missing_or_none_are_refused(self):
        server = self.start_server()
        self.assert_refused_by_all(server.url, "none.credentials",
                                   options=["--credentials", "none.credentials"])
        self.write("bad.credentials", "hello\n")
        self.assert_refused_by_all(server.url, "bad.credentials: no credentials",
                                   options=["--credentials", "bad.credentials"])

    def test_a_url_with_a_password_is_refused(self):
        self.assert_refused_by_all("nats://me:secret@localhost", "--credentials")

    def test_two_names_of_one_cluster_are_refused(self):
        self.assert_refused_by_all("nats://a/one,nats://b/two", "'one'", "'two'")

    def test_an_address_that_is_none_is_refused(self):
        for url in ("lab-server", "http://lab", "nats://lab:99999", "nats://a,tls://b"):
            self.assert_refused_by_all(url)

    def test_a_worker_without_cores_is_refused(self):
        self.assert_refused(self.run_program("worker", "nats://localhost", "--threads", 0),
                            "--threads")

    def test_a_server_that_is_away_keeps_nobody_from_evolving(self):
        with socket.create_server((HOST, 0)) as listener:
            port = listener.getsockname()[1]
        url = f"nats://{HOST}:{port}"
        self.assert_refused(self.run_program("cluster", url), "cannot reach")
        run = self.evolve("alone", "--cluster", url)
        self.finish(run)
        self.assertIn("nothing answers there", run.log.read_text())
        worker = self.start_worker(url)
        self.wait_for_message(worker, "nothing answers there; trying again")
        self.assertEqual(self.interrupt(worker), 0)


if __name__ == "__main__":
    unittest.main()
