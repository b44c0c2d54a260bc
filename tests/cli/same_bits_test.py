"""One evolution, run by the program in several ways, has the digest that tests/golden/digests.txt
records for every platform."""

import unittest

from experiment_tables import digests
from program import ROOT
from studio_driver import StudioTest

SETTINGS = ROOT / "tests/golden/run.toml"
GENERATIONS = 20


def recorded():
    for line in (ROOT / "tests/golden/digests.txt").read_text().splitlines():
        if line.startswith("evolution.1_threads.last "):
            return line.split()[1]
    raise LookupError("evolution.1_threads.last")


class SameBits(StudioTest):
    def assert_recorded(self, path):
        kept = digests(path)
        self.assertGreaterEqual(len(kept), GENERATIONS)
        last = kept[GENERATIONS - 1] % 2**64  # SQLite reads large ones as negative
        self.assertEqual(f"{last:016x}", recorded())

    def test_on_any_number_of_threads_it_is_the_same_run(self):
        for threads in [1, 2, 7]:
            name = f"on-{threads}.cambrian"
            self.run_well("evolve", SETTINGS, "-t", threads, "-o", name)
            self.assert_recorded(self.folder / name)

    def test_resumed_it_is_the_same_run(self):
        self.run_well("evolve", SETTINGS, "-n", 1, "-t", 2, "-o", "a.cambrian")
        for generations in [2, 9, 19, GENERATIONS]:
            self.run_well("evolve", "-r", "a.cambrian", "-n", generations)
        self.assert_recorded(self.folder / "a.cambrian")

    def test_in_the_window_it_is_the_same_run(self):
        display = self.open_display(painted=False)
        self.start(display, SETTINGS)
        self.click("Evolve")
        self.wait_for("generation", number=GENERATIONS - 1)
        self.quit()
        self.assert_recorded(self.folder / "state" / "experiment.cambrian")


if __name__ == "__main__":
    unittest.main()
