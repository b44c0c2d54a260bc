"""Permissions on a cluster's server with the installed configuration, and encryption."""

import base64
import json
import os
import re
import socket
import subprocess
import time
import unittest

import nats_tokens
from cluster_program import ClusterTest
from nats_server import HOST
from network_cut import CuttableNetwork
from program import CAMBRIAN, ROOT

SAMPLE = ROOT / "assets/nats.conf"

WORKER = ("worker", "worker-password")
WORKER_TWO = ("worker-two", "worker-two-password")
COORDINATOR = ("coordinator", "coordinator-password")
RUN = "%016x" % 5

# A generation takes about two seconds on a core, so that attackers can answer in time.
ENDLESS = """
[run]
generations = 100000
[population]
size = 300
[trial]
duration = 30
"""

# Actions that are forbidden to the roles; each one is tried below.
FORBIDDEN_TO_WORKERS = [
    ("publish", f"cambrian.work.{RUN}.1.1"),               # hand out work
    ("publish", f"cambrian.stop.{RUN}"),                   # end a run
    ("publish", f"cambrian.hello.coordinator.{RUN}"),      # refuse other workers
    ("publish", "$KV.cambrian-settings.x"),                # change settings
    ("publish", "$JS.API.STREAM.CREATE.other"),            # add streams
    ("publish", "$JS.API.STREAM.DELETE.cambrian-WORK"),
    ("publish", "$JS.API.STREAM.PURGE.cambrian-WORK"),
    ("publish", "$JS.API.STREAM.PURGE.cambrian-RESULT"),
    ("publish", "$JS.API.STREAM.MSG.GET.cambrian-RESULT"),
    ("publish", "$JS.API.CONSUMER.CREATE.cambrian-RESULT"),
    ("publish", "$JS.API.CONSUMER.DELETE.cambrian-WORK.workers"),
    ("publish", "_INBOX.cambrian.coordinator.x"),          # answer for the server
    ("publish", f"cambrian.result.{RUN}.1.1"),             # send results without a name
    ("publish", f"cambrian.result.{RUN}.1.1.worker-two"),  # send them for another worker
    ("publish", f"cambrian.hello.worker.worker-two.{RUN}"),
    ("publish", "elsewhere"),
    ("subscribe", "_INBOX.>"),                             # read answers to others
    ("subscribe", "_INBOX.cambrian.worker.>"),
    ("subscribe", "_INBOX.cambrian.worker.worker-two.>"),
    ("subscribe", "_INBOX.cambrian.coordinator.>"),
    ("subscribe", "cambrian.work.>"),
    ("subscribe", "cambrian.result.>"),
    ("subscribe", ">"),
]
FORBIDDEN_TO_COORDINATORS = [
    ("publish", f"cambrian.result.{RUN}.1.1.worker"),      # pretend to be a worker
    ("publish", f"cambrian.hello.worker.worker.{RUN}"),
    ("publish", "$JS.ACK.cambrian-WORK.workers.1.1.1.1.1"),
    ("publish", "$JS.API.STREAM.DELETE.cambrian-WORK"),
    ("publish", "$JS.API.STREAM.CREATE.other"),
    ("publish", "$JS.API.STREAM.UPDATE.cambrian-WORK"),
    ("publish", "$JS.API.STREAM.PURGE.other"),
    ("publish", "$JS.API.CONSUMER.MSG.NEXT.cambrian-WORK.workers"),
    ("subscribe", "_INBOX.cambrian.worker.>"),
    ("subscribe", "cambrian.result.>"),
    ("subscribe", ">"),
]


def sample_permissions():
    """Returns the sample configuration without the parts that the tests' server sets itself."""
    text = SAMPLE.read_text()
    text = re.sub(r"^(host|port):.*$", "", text, flags=re.MULTILINE)
    return re.sub(r"^jetstream \{.*?^\}$", "", text, flags=re.MULTILINE | re.DOTALL)


class SecurityTest(ClusterTest):
    def credentials(self, name, who):
        self.write(name, f'user = "{who[0]}"\npassword = "{who[1]}"\n').chmod(0o600)
        return "--credentials", name


class Roles(SecurityTest):
    def test_the_sample_configuration_is_one(self):
        server = self.start_server(sample_permissions())
        self.assertIsNone(server.process.poll())
        self.assertIn("store_dir", SAMPLE.read_text())

    def test_a_run_and_its_workers_need_no_more_than_their_roles(self):
        server = self.start_server(sample_permissions())
        worker = self.credentials("worker.credentials", WORKER)
        coordinator = self.credentials("me.credentials", COORDINATOR)
        second = self.credentials("two.credentials", WORKER_TWO)
        workers = [self.start_worker(server.url, "worker", *each) for each in (worker, second)]
        self.evolve_until(lambda sums: sums["units"] > 12, server.url, *coordinator, least=2)
        self.assertEqual(len(self.wait_for_workers(server.url, 2, *coordinator)), 2)
        for process in workers:
            self.assertEqual(self.interrupt(process), 0)
            self.assertNotIn("permit", process.log.read_text())

    def assert_forbidden(self, server, who, actions):
        for action, subject in actions:
            with self.subTest(role=who[0], action=action, subject=subject):
                client = server.client(user=who[0], password=who[1])
                if action == "publish":
                    client.publish(subject, b"{}")
                else:
                    client.subscribe(subject)
                errors, _ = client.flush()
                self.assertRegex(" ".join(errors), "Permissions Violation")
                client.close()

    def test_each_role_is_kept_from_everything_else(self):
        server = self.start_server(sample_permissions())
        coordinator = self.credentials("me.credentials", COORDINATOR)
        self.finish(self.evolve("first", "--cluster", server.url, *coordinator))  # makes streams
        self.assert_forbidden(server, WORKER, FORBIDDEN_TO_WORKERS)
        self.assert_forbidden(server, COORDINATOR, FORBIDDEN_TO_COORDINATORS)

    def test_the_wrong_credentials_are_one_message(self):
        server = self.start_server(sample_permissions())
        self.write("settings.toml", "[run]\ngenerations = 1\n")
        wrong = self.credentials("wrong.credentials", ("worker", "guess"))
        for command in (["worker", server.url], ["cluster", server.url],
                        ["evolve", "settings.toml", "--cluster", server.url]):
            result = self.run_program(*command, *wrong)
            self.assert_refused(result, "does not accept the credentials of wrong.credentials")
            self.assertEqual(result.stderr.count("\n"), 1)
            self.assert_refused(self.run_program(*command), "--credentials FILE")

    def test_the_credentials_of_the_other_role_are_one_message(self):
        server = self.start_server(sample_permissions())
        self.write("settings.toml", "[run]\ngenerations = 1\n")
        worker = self.credentials("worker.credentials", WORKER)
        coordinator = self.credentials("me.credentials", COORDINATOR)
        result = self.run_program("evolve", "settings.toml", "--cluster", server.url, *worker)
        self.assert_refused(result, "does not permit", "cambrian-WORK")
        result = self.run_program("cluster", server.url, *worker)
        self.assert_refused(result, "does not permit", "cambrian.hello.>")
        result = self.run_program("worker", server.url, *coordinator)
        self.assert_refused(result, "does not permit")


class Attacker:
    """A client with a worker's password that takes units and may answer anything."""

    INBOX = "_INBOX.cambrian.worker.worker-two.attacker"

    def __init__(self, server):
        self.client = server.client(user=WORKER_TWO[0], password=WORKER_TWO[1])
        self.client.subscribe(self.INBOX + ".unit")
        self.settings = {}

    def greet(self, proof_of, ids):
        for each in ids:
            hello = proof_of | {"role": "worker", "id": f"fnv1a64:{each:016x}", "name": "attacker",
                                "refusals": [], "trials": []}
            self.client.publish(f"cambrian.hello.worker.worker-two.{each:016x}",
                                json.dumps(hello).encode())

    def take_unit(self):
        """Returns run, generation and number of the next unit and its body; None without one."""
        self.client.publish("$JS.API.CONSUMER.MSG.NEXT.cambrian-WORK.workers",
                            b'{"batch": 1, "expires": 300000000}', self.INBOX + ".unit")
        end = time.monotonic() + 0.4
        while time.monotonic() < end:
            for subject, body in self.client.flush()[1]:
                found = re.match(r"cambrian\.work\.([0-9a-f]{16}\.\d+\.\d+)$", subject)
                if found:
                    self.client.publish(self.client.replies[-1], b"+ACK")
                    return found[1], body.split(b"\r\n\r\n", 1)[1]
            time.sleep(0.01)
        return None

    def true_result(self, body):
        key = json.loads(body.split(b"\n", 1)[0])["settings"].split(":")[1]
        if key not in self.settings:
            answer = self.client.request(
                "$JS.API.STREAM.MSG.GET.KV_cambrian-settings",
                json.dumps({"last_by_subj": f"$KV.cambrian-settings.{key}"}).encode(),
                inbox=self.INBOX + ".settings")
            self.settings[key] = base64.b64decode(answer["message"]["data"])
        settings = self.settings[key]
        question = json.dumps({"format": "cambrian-question", "version": 1,
                               "settingsBytes": len(settings)}).encode() + b"\n" + settings + body
        done = subprocess.run([CAMBRIAN, "worker", "--unit"], input=question, capture_output=True,
                              check=True)
        return json.loads(done.stdout)

    def send(self, unit, result, worker):
        text = json.dumps(result | {"worker": f"fnv1a64:{worker:016x}", "deliveries": 1}).encode()
        self.client.publish(f"cambrian.result.{unit}.worker-two", text)


class Attacks(SecurityTest):
    """What one worker's password can do to a run of somebody else."""

    def start_run(self, server):
        options = self.credentials("me.credentials", COORDINATOR)
        with open(self.folder / "run.json", "wb") as lines:
            run = self.evolve("run", "--cluster", server.url, *options, settings=ENDLESS,
                              stdout=lines)
        client = server.client(user=COORDINATOR[0], password=COORDINATOR[1])
        client.subscribe("cambrian.hello.coordinator.*")
        [(_, text), *_] = self.listen(client, lambda: client.messages, 1)
        return run, json.loads(text)

    def test_two_invented_workers_of_one_password_neither_end_a_run_nor_change_it(self):
        server = self.start_server(sample_permissions())
        run, hello = self.start_run(server)
        attacker = Attacker(server)
        end = time.monotonic() + 120
        told = "several workers with the login worker-two differed"
        while told not in run.log.read_text() and time.monotonic() < end:
            attacker.greet(hello, (0xdead1, 0xdead2))
            taken = attacker.take_unit()
            if not taken:
                continue
            result = attacker.true_result(taken[1])
            for each in result["results"]:
                each["fitness"] = 0.001
            for worker in (0xdead1, 0xdead2):
                attacker.send(taken[0], result, worker)
        attacker.client.close()
        self.assertIn(told, run.log.read_text())
        self.assertIsNone(run.poll())
        self.end_and_compare(run, "run", ENDLESS, 2)

    def test_results_without_a_greeting_do_not_count(self):
        server = self.start_server(sample_permissions())
        run, hello = self.start_run(server)
        run_id = hello["id"].split(":")[1]
        client = server.client(user=WORKER[0], password=WORKER[1])
        result = {"format": "cambrian-result", "version": 1, "worker": f"fnv1a64:{7:016x}",
                  "deliveries": 1, "seconds": 0, "results": []}
        for generation in range(1, 200):
            for _ in range(10):
                client.publish(f"cambrian.result.{run_id}.{generation}.0.worker",
                               json.dumps(result).encode())
        client.flush()
        client.close()
        self.wait_for_message(run, "results of workers that have not announced themselves")
        self.end_and_compare(run, "run", ENDLESS, 2)
        lines = [line for line in run.log.read_text().splitlines() if "result" in line]
        self.assertLessEqual(len(lines), 5, lines)

    def test_a_thousand_invented_workers_are_a_few_lines(self):
        server = self.start_server(sample_permissions())
        run, hello = self.start_run(server)
        hello |= {"role": "worker", "refusals": [], "trials": [], "simulator": "0.1"}
        client = server.client(user=WORKER[0], password=WORKER[1])
        for number in range(1_000):
            hello |= {"id": f"fnv1a64:{number:016x}", "name": f"no {number}"}
            client.publish(f"cambrian.hello.worker.worker.{number:016x}",
                           json.dumps(hello).encode())
        client.flush()
        client.close()
        self.wait_for_message(run, "workers are refused so far")
        self.end_and_compare(run, "run", ENDLESS, 2)
        lines = run.log.read_text().splitlines()
        self.assertLessEqual(len([line for line in lines if "refused" in line]), 8, lines)


class Openness(SecurityTest):
    """What of a login is open to others is said once, by every command."""

    def warnings_of(self, url, *options):
        self.write("settings.toml", "[run]\ngenerations = 1\n[population]\nsize = 6\n")
        run = self.run_well("evolve", "settings.toml", "--cluster", url, *options, "--out",
                            "/dev/null")
        worker = self.start_worker(url, "worker", *options)
        self.wait_for_message(worker, "connected")
        return [run.stderr, worker.log.read_text(),
                self.run_well("cluster", url, *options).stderr]

    def test_credentials_that_others_can_read_are_told_of(self):
        server = self.start_server()
        options = self.credentials("my own.credentials", WORKER)
        words = "other users of this machine can read it; chmod 600 'my own.credentials' ends this"
        for messages in self.warnings_of(server.url, *options):
            self.assertNotIn("other users", messages)
        (self.folder / "my own.credentials").chmod(0o640)
        for messages in self.warnings_of(server.url, *options):
            self.assertEqual(messages.count(words), 1, messages)

    def test_a_password_on_an_open_connection_is_told_of(self):
        server = self.start_server("host: 0.0.0.0\n")
        url = f"nats://{socket.gethostname()}:{server.port}"  # a name, which may lead anywhere
        options = self.credentials("me.credentials", WORKER)
        for messages in self.warnings_of(url, *options):
            self.assertIn("readable and unsigned", messages)
            self.assertIn("so does the password of me.credentials", messages)


class RefusingNetwork(CuttableNetwork):
    """Answers so many of the first connections as a server does that refuses a signature."""

    def __init__(self, port, refusals):
        self.left_to_refuse = refusals
        super().__init__(port)

    def forward_all(self, near):
        if self.left_to_refuse == 0:
            super().forward_all(near)
            return
        self.left_to_refuse -= 1
        with socket.create_connection((HOST, self.port), 5) as far:
            near.sendall(far.recv(65536))  # what the server says of itself, and what is to be signed
        near.recv(65536)
        near.sendall(b"-ERR 'Authorization Violation'\r\n")
        self.end(near)


class Tokens(SecurityTest):
    """Credentials files in the format of NATS's own tools (*.creds)."""

    def setUp(self):
        super().setUp()
        self.account, self.user, self.stranger = (self.key(each) for each in ("A", "U", "A"))
        self.server = self.start_server(nats_tokens.configuration(self.key("O"), self.key("A"),
                                                                  self.account))

    def key(self, letter):
        self.keys = getattr(self, "keys", 0) + 1
        return nats_tokens.Key(letter, self.folder / f"key{self.keys}.pem")

    def test_a_run_with_signed_tokens_is_the_same_run(self):
        self.write("good.creds", nats_tokens.user_credentials(self.account, self.user))
        good = "--credentials", "good.creds"
        worker = self.start_worker(self.server.url, "worker", *good)
        self.evolve_until(lambda sums: sums["units"] > 0, self.server.url, *good)
        self.wait_for_message(worker, "connected")

    def test_a_signature_that_is_refused_by_chance_is_made_again(self):
        self.write("good.creds", nats_tokens.user_credentials(self.account, self.user))
        network = RefusingNetwork(self.server.port, 2)
        self.addCleanup(network.close)
        self.run_well("cluster", network.url, "--credentials", "good.creds")
        self.assertEqual(network.left_to_refuse, 0)

    def test_a_token_that_is_not_accepted_is_one_message(self):
        self.write("settings.toml", "[run]\ngenerations = 1\n")
        wrong = {"stranger.creds": nats_tokens.user_credentials(self.stranger, self.user),
                 "seed.creds": nats_tokens.user_credentials(self.account, self.user,
                                                            self.key("U").seed)}
        for name, text in wrong.items():
            self.write(name, text)
            for command in (["worker", self.server.url], ["cluster", self.server.url],
                            ["evolve", "settings.toml", "--cluster", self.server.url]):
                result = self.run_program(*command, "--credentials", name)
                self.assert_refused(result, f"does not accept the credentials of {name}")
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)


class Encryption(SecurityTest):
    """Certificates made by openssl, for the name localhost unless given."""

    def make_authority(self):
        self.openssl("req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", "ca.key", "-out",
                     "ca.pem", "-subj", "/CN=lab", "-days", "30")

    def openssl(self, *arguments):
        done = subprocess.run(["openssl", *arguments], cwd=self.folder, capture_output=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def make_certificate(self, host="localhost", until="20990101000000Z"):
        self.write("index.txt", "")
        self.write("serial", "1000\n")
        self.write("ca.cnf", "[ca]\ndefault_ca=here\n[here]\ndatabase=index.txt\nserial=serial\n"
                             "new_certs_dir=.\ncertificate=ca.pem\nprivate_key=ca.key\n"
                             "default_md=sha256\npolicy=any\n[any]\ncommonName=supplied\n"
                             f"[names]\nsubjectAltName=DNS:{host}\n")
        self.openssl("req", "-newkey", "rsa:2048", "-nodes", "-keyout", "server.key", "-out",
                     "server.csr", "-subj", f"/CN={host}")
        self.openssl("ca", "-batch", "-config", "ca.cnf", "-in", "server.csr", "-out",
                     "server.pem", "-startdate", "20200101000000Z", "-enddate", until,
                     "-extensions", "names", "-notext")

    def start_encrypted(self, **certificate):
        self.make_authority()
        self.make_certificate(**certificate)
        tls = (f'tls {{ cert_file: "{self.folder}/server.pem", '
               f'key_file: "{self.folder}/server.key" }}\n')
        return self.start_server(tls + sample_permissions())

    def assert_nobody_connects(self, url, *parts, options=()):
        self.write("settings.toml", "[run]\ngenerations = 1\n")
        for command in (["worker", url], ["cluster", url],
                        ["evolve", "settings.toml", "--cluster", url]):
            result = self.run_program(*command, *options)
            self.assert_refused(result, *parts)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)

    def test_a_run_over_an_encrypted_connection_is_the_same_run(self):
        server = self.start_encrypted()
        worker = self.credentials("worker.credentials", WORKER)
        coordinator = self.credentials("me.credentials", COORDINATOR)
        self.start_worker(server.tls_url, "worker", "--ca", "ca.pem", *worker)
        self.evolve_until(lambda sums: sums["units"] > 0, server.tls_url, "--ca", "ca.pem",
                          *coordinator)

    def test_a_certificate_of_an_unknown_authority_is_not_trusted(self):
        server = self.start_encrypted()
        self.assert_nobody_connects(server.tls_url, "cannot trust the server", "--ca FILE")

    def test_a_certificate_of_another_host_is_not_trusted(self):
        server = self.start_encrypted(host="other.lab")
        self.assert_nobody_connects(server.tls_url, "cannot trust the server", "mismatch",
                                    options=["--ca", "ca.pem"])

    def test_a_certificate_that_has_expired_is_not_trusted(self):
        server = self.start_encrypted(until="20210101000000Z")
        self.assert_nobody_connects(server.tls_url, "cannot trust the server", "expired",
                                    options=["--ca", "ca.pem"])

    def test_a_server_without_encryption_is_not_taken_for_one_with(self):
        server = self.start_server()
        self.make_authority()
        self.assert_nobody_connects(server.tls_url, "has no encryption",
                                    options=["--ca", "ca.pem"])

    def test_an_authority_that_is_a_pipe_is_refused_at_once(self):
        os.mkfifo(self.folder / "ca.pem")
        self.assert_nobody_connects(f"tls://{HOST}:4222", "ca.pem is not a regular file",
                                    options=["--ca", "ca.pem"])

    def test_an_authority_that_is_no_certificate_is_refused(self):
        self.write("ca.pem", "hello\n")
        self.assert_nobody_connects(f"tls://{HOST}:4222", "--ca ca.pem",
                                    options=["--ca", "ca.pem"])


if __name__ == "__main__":
    unittest.main()
