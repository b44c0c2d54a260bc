"""The studio in a real X window with a real server and real workers on this machine."""

import subprocess
import unittest

from experiment_tables import digests
from nats_server import NatsServer
from program import CAMBRIAN
from studio_driver import StudioTest

# A generation takes about a second, so that its progress can be observed.
SETTINGS = """
[population]
size = 40
[trial]
duration = 20
"""
GENERATIONS = 4


class StudioOnSeveralMachines(StudioTest):
    def start_server(self):
        server = NatsServer(self.folder / "server")
        self.addCleanup(server.kill)
        return server

    def start_worker(self, server, name):
        worker = subprocess.Popen(
            [CAMBRIAN, "worker", server.url, "--threads", "1", "--name", name,
             "--priority", "normal"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(self.stop, worker)
        return worker

    def type_into_field(self, name, text):
        self.click(name)
        self.type_over(text)

    def open_card(self):
        self.press("ctrl+m")
        self.place_of("Server")

    def local_digests(self):
        self.run_well("evolve", "cluster.toml", "--generations", GENERATIONS, "--out",
                      "local.cambrian")
        return digests(self.folder / "local.cambrian")[:GENERATIONS]

    def test_a_person_joins_a_cluster_loses_it_and_leaves_it(self):
        self.write("cluster.toml", SETTINGS)
        server = self.start_server()
        for i in range(2):
            self.start_worker(server, f"lab-{i}")
        display = self.open_display()
        self.start(display, "cluster.toml")
        self.open_card()
        self.type_into_field("Server", server.url)
        display.tool("key", "Return")
        self.wait_for("cluster joined", server=server.url)
        self.click("Evolve")
        _, after = self.wait_for("machines", machines=3, cores=3, link="connected")
        self.wait_for("generation", number=0)
        self.place_of("machine lab-1")
        self.assert_painted(display.picture("machines-1280x800.png"))
        self.press("Escape")
        server.kill()
        told, after = self.wait_for("notice", after=after, problem=True)
        self.assertIn("working alone", told["text"])
        _, after = self.wait_for("machines", after=after, link="away")
        display.picture("machines-away-1280x800.png")
        last = max(event["number"] for event in self.events() if event["event"] == "generation")
        _, after = self.wait_for("generation", after=after, number=last + 1)
        server.start()
        _, after = self.wait_for("machines", after=after, machines=3, link="connected")
        self.click("machines line")
        self.click("Work alone")
        _, after = self.wait_for("cluster left", after=after)
        self.wait_for("generation", after=after)
        last = max(event["number"] for event in self.events() if event["event"] == "generation")
        self.wait_for("generation", number=max(last, GENERATIONS))
        self.press("Escape")
        self.press("space")
        self.wait_for("paused")
        kept = self.save_as("ctrl+k", "kept")
        self.quit()
        self.assertEqual(digests(kept)[:GENERATIONS], self.local_digests())

    def test_the_cluster_is_remembered_and_used_again(self):
        self.write("cluster.toml", SETTINGS)
        server = self.start_server()
        self.start_worker(server, "lab-0")
        display = self.open_display(painted=False)
        self.start(display, "cluster.toml", "--cluster", server.url)
        self.wait_for("machines", machines=2, link="connected")
        self.quit()
        self.start(display, "cluster.toml")
        self.wait_for("cluster joined", server=server.url)
        self.wait_for("machines", machines=2, link="connected")
        self.quit()
        self.assertIn(f"server = {server.url}", (self.folder / "state/cluster.conf").read_text())

    def test_a_server_that_is_none_is_told_in_words(self):
        self.write("cluster.toml", SETTINGS)
        display = self.open_display()
        self.start(display, "cluster.toml")
        self.open_card()
        for address, words in (("nats://me:secret@localhost", "password"),
                               ("http://localhost", "nats://"),
                               ("nats://nowhere.invalid", "nowhere.invalid")):
            after = len(self.events())
            self.type_into_field("Server", address)
            display.tool("key", "Return")
            refused, _ = self.wait_for("cluster refused", after=after)
            self.assertIn(words, refused["problem"])
        display.picture("machines-refused-1280x800.png")
        self.press("Escape")
        self.press("g")
        self.wait_for("generation", number=0)
        self.quit()

    def test_a_large_window_shows_seven_workers(self):
        self.write("cluster.toml", SETTINGS)
        server = self.start_server()
        for i in range(7):
            self.start_worker(server, f"lab-{i}")
        display = self.open_display(1920, 1080)
        self.start(display, "cluster.toml", "--cluster", server.url, "--evolve", "--width", "1920",
                   "--height", "1080")
        self.wait_for("machines", machines=8, cores=8, link="connected")
        self.wait_for("generation", number=1)
        self.open_card()
        self.display.wait_for_frames(4)
        self.assert_painted(display.picture("machines-1920x1080.png"))
        self.quit()


if __name__ == "__main__":
    unittest.main(verbosity=2)
