"""A NATS server from Debian's package for one test, and a client that can send malformed
messages."""

import contextlib
import json
import pathlib
import shutil
import signal
import socket
import ssl
import subprocess
import time
import unittest

SERVER = shutil.which("nats-server") or shutil.which("nats-server", path="/usr/sbin")
HOST = "127.0.0.1"
LONGEST_START = 20  # s

# A configuration with one user who may do everything, and JetStream.
PLAIN = ""


class NatsServer:
    """Runs in its own folder, on a free port, for this machine only."""

    def __init__(self, folder, configuration=PLAIN, jetstream=True):
        if SERVER is None:
            raise unittest.SkipTest("the package nats-server is not installed")
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.configuration = configuration
        self.jetstream = jetstream
        self.port = -1  # any free port
        self.process = None
        self.start()

    def start(self):
        ports = self.folder / "ports"
        shutil.rmtree(ports, ignore_errors=True)
        ports.mkdir()
        store = f'jetstream {{ store_dir: "{self.folder}/store" }}\n' if self.jetstream else ""
        (self.folder / "nats.conf").write_text(
            f'host: {HOST}\nport: {self.port}\nports_file_dir: "{ports}"\n'
            f'{store}{self.configuration}')
        with open(self.folder / "server.log", "ab") as log:
            self.process = subprocess.Popen(
                [SERVER, "-c", self.folder / "nats.conf"], stdin=subprocess.DEVNULL, stdout=log,
                stderr=log)
        end = time.monotonic() + LONGEST_START
        while time.monotonic() < end and self.process.poll() is None:
            for file in ports.glob("*.ports"):
                with contextlib.suppress(ValueError, KeyError):  # the file is being written
                    self.port = int(json.loads(file.read_text())["nats"][0].rsplit(":", 1)[1])
                    self.wait_until_it_answers()
                    return
            time.sleep(0.02)
        self.kill()
        raise AssertionError((self.folder / "server.log").read_text())

    def wait_until_it_answers(self):
        end = time.monotonic() + LONGEST_START
        while time.monotonic() < end:
            with contextlib.suppress(OSError), socket.create_connection((HOST, self.port), 1) as it:
                if it.recv(5) == b"INFO ":
                    return
            time.sleep(0.02)

    @property
    def url(self):
        return f"nats://{HOST}:{self.port}"

    @property
    def tls_url(self):
        return f"tls://localhost:{self.port}"

    def kill(self):
        """Kills the server, as a power failure would."""
        self.end(signal.SIGKILL)

    def stop(self):
        self.end(signal.SIGTERM)

    def end(self, with_signal):
        if self.process.poll() is None:
            self.process.send_signal(with_signal)
        self.process.wait(30)

    def client(self, **options):
        return NatsClient(self.port, **options)


class NatsClient:
    """A client that implements the protocol itself, so that it can send anything."""

    def __init__(self, port, user=None, password=None, authority=None):
        self.stream = socket.create_connection((HOST, port), 5)
        self.lines = self.stream.makefile("rb")
        self.lines.readline()  # INFO
        if authority:
            context = ssl.create_default_context(cafile=authority)
            self.stream = context.wrap_socket(self.stream, server_hostname="localhost")
            self.lines = self.stream.makefile("rb")
        options = {"verbose": False, "pedantic": False, "headers": True, "no_responders": True}
        if user:
            options |= {"user": user, "pass": password}
        self.send(f"CONNECT {json.dumps(options)}\r\nPING\r\n".encode())
        self.errors = []
        self.messages = []
        self.replies = []  # subjects on which the senders of messages expect answers
        self.until_pong()

    def close(self):
        self.lines.close()
        self.stream.close()

    def send(self, data):
        self.stream.sendall(data)

    def publish(self, subject, body=b"", reply=""):
        self.send(f"PUB {subject} {reply} {len(body)}\r\n".encode() + body + b"\r\n")

    def subscribe(self, subject, number=1):
        self.send(f"SUB {subject} {number}\r\n".encode())

    def until_pong(self):
        """Reads the server's messages until it answers a PING that was sent."""
        while True:
            line = self.lines.readline()
            if not line:
                raise ConnectionError("the server has closed the connection")
            if line.startswith(b"PONG"):
                return
            if line.startswith(b"PING"):
                self.send(b"PONG\r\n")
            elif line.startswith(b"-ERR"):
                self.errors.append(line.decode().strip())
            elif line.startswith((b"MSG", b"HMSG")):
                fields = line.decode().split()
                body = self.lines.read(int(fields[-1]) + 2)[:-2]
                self.messages.append((fields[1], body))
                if len(fields) == (5 if fields[0] == "MSG" else 6):
                    self.replies.append(fields[3])

    def flush(self):
        """Returns the server's errors and messages about everything sent before."""
        self.errors, self.messages, self.replies = [], [], []
        self.send(b"PING\r\n")
        self.until_pong()
        return self.errors, self.messages

    def request(self, subject, body=b"", seconds=5, inbox="_INBOX.test.request"):
        """Returns the answer as JSON; {} if none arrives in time."""
        self.subscribe(inbox, 77)
        self.publish(subject, body, inbox)
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            errors, messages = self.flush()
            for where, text in messages:
                if where == inbox:
                    return json.loads(text) if text.startswith(b"{") else {}
            if errors:
                break
            time.sleep(0.01)
        return {}

    def messages_in(self, stream):
        return self.request(f"$JS.API.STREAM.INFO.{stream}")["state"]["messages"]
