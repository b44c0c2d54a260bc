"""`cambrian compare` gives the same table on several machines as on one."""

import csv
import unittest

from cluster_program import ClusterTest

SETTINGS = """
[population]
size = 30
[trial]
duration = 6
"""
COMPARISON = ("compare", "--world", "world.toml", "--sweep", "selection.survival=0.1,0.3",
              "--seeds", "1..2", "--trials", 90)


class CompareOnSeveralMachines(ClusterTest):
    def table(self, folder):
        """Returns the table without the times of the runs."""
        with (self.folder / folder / "runs.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            del row["core_seconds"]
        return rows

    def champions(self, folder):
        return {path.name: path.read_bytes()
                for path in (self.folder / folder / "champions").iterdir()}

    def test_a_comparison_on_a_cluster_comes_to_the_same_digits(self):
        self.write("world.toml", SETTINGS)
        self.run_well(*COMPARISON, "--threads", 1, "--out", "near")
        server = self.start_server()
        for i in range(2):
            self.wait_for_message(self.start_worker(server.url, f"worker {i}"), "waiting")
        self.run_well(*COMPARISON, "--threads", 4, "--out", "far", "--cluster", server.url)
        self.assertEqual(len(self.table("near")), 4)
        self.assertEqual(self.table("far"), self.table("near"))
        self.assertEqual(self.champions("far"), self.champions("near"))
        self.assertEqual((self.folder / "far/report.md").read_text(),
                         (self.folder / "near/report.md").read_text())

    def test_a_comparison_on_a_cluster_that_is_none_writes_nothing(self):
        self.write("world.toml", SETTINGS)
        result = self.run_program(*COMPARISON, "--out", "far", "--cluster",
                                  "nats://nowhere.invalid")
        self.assertEqual(result.returncode, 2)
        self.assertIn("nowhere.invalid", result.stderr)
        self.assertFalse((self.folder / "far").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
