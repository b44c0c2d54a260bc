"""A network between programs on this machine that can be cut."""

import contextlib
import socket
import threading

from nats_server import HOST


class CuttableNetwork:
    """Forwards connections to a port. While it is cut, nothing arrives and neither end is told that
    the connection is lost. Data sent during the cut arrive when it is repaired."""

    def __init__(self, port):
        self.port = port
        self.whole = threading.Event()
        self.whole.set()
        self.listener = socket.create_server((HOST, 0))
        self.streams = []
        threading.Thread(target=self.accept, daemon=True).start()

    @property
    def url(self):
        return f"nats://{HOST}:{self.listener.getsockname()[1]}"

    def cut(self):
        self.whole.clear()

    def repair(self):
        self.whole.set()

    def close(self):
        self.repair()
        for stream in [self.listener, *self.streams]:
            self.end(stream)

    def accept(self):
        with contextlib.suppress(OSError):
            while True:
                near, _ = self.listener.accept()
                self.streams.append(near)
                threading.Thread(target=self.forward_all, args=(near,), daemon=True).start()

    def forward_all(self, near):
        self.whole.wait()
        with contextlib.suppress(OSError):
            far = socket.create_connection((HOST, self.port), 5)
            far.settimeout(None)
            self.streams.append(far)
            threading.Thread(target=self.forward, args=(far, near), daemon=True).start()
            self.forward(near, far)

    def forward(self, source, target):
        with contextlib.suppress(OSError):
            while data := source.recv(65536):
                self.whole.wait()
                target.sendall(data)
        self.whole.wait()
        for stream in (source, target):
            self.end(stream)

    @staticmethod
    def end(stream):
        with contextlib.suppress(OSError):
            stream.shutdown(socket.SHUT_RDWR)
        stream.close()
