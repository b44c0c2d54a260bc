"""Preserves: reported, kept, resumed, verified, exported, and after a crash."""

import csv
import json
import shutil
import subprocess
import unittest

from experiment_tables import opened
from program import FERTILE, ROOT, SMALL, ProgramTest

POND = """
[preserve]
width = 8
height = 6
founders = 8
energy-density = 100
"""
POND_ENERGY = 8 * 6 * 100  # J
CROWD = """
[preserve]
width = 40
height = 25
founders = 100
"""
SWIMMERS = [ROOT / "assets/creatures/finned_swimmer.creature.json",
            ROOT / "assets/creatures/squid.creature.json"]
OLDER = ROOT / "tests/persist/versions/older_simulator/walker.creature.json"


class Preserve(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("pond.toml", POND)

    def rows(self, *arguments):
        """Returns the reported rows without what depends on the clock."""
        report = self.run_well("preserve", *arguments, "--json").stdout
        rows = [json.loads(line) for line in report.splitlines()]
        for row in rows:
            del row["real_time_factor"]
        return rows

    def snapshots(self, name):
        with opened(self.folder / name) as file:
            return file.execute("SELECT tick, digest FROM snapshots ORDER BY tick").fetchall()

    def test_a_preserve_reports_the_same_on_any_number_of_threads(self):
        one, two, seven = [self.rows("pond.toml", "--founders", *SWIMMERS, "--seconds", 60,
                                     "-t", threads) for threads in (1, 2, 7)]
        self.assertEqual(len(one), 6)
        self.assertEqual(one, two)
        self.assertEqual(one, seven)
        self.assertNotEqual(one, self.rows("pond.toml", "--founders", *SWIMMERS, "--seconds", 60,
                                           "--seed", 2))
        for row in one:
            self.assertAlmostEqual(sum(row["energy"].values()), POND_ENERGY, places=5)

    def test_a_hundred_creatures_are_the_same_on_any_number_of_threads(self):
        self.write("crowd.toml", CROWD)
        one, two, seven = [self.rows("crowd.toml", "-f", *SWIMMERS, "--seconds", 60, "-t", threads)
                           for threads in (1, 2, 7)]
        self.assertEqual(len(one), 6)
        self.assertGreaterEqual(one[0]["population"], 90)
        self.assertEqual(one, two)
        self.assertEqual(one, seven)

    def test_a_preserve_whose_edges_meet_is_resumed_and_verified(self):
        self.write("torus.toml", POND + 'edges = "wrap"\n')
        uncut = self.rows("torus.toml", "-f", *SWIMMERS, "--seconds", 120, "-t", 2)
        self.assertNotEqual(uncut[:6], self.rows("pond.toml", "-f", *SWIMMERS, "--seconds", 60))
        self.rows("torus.toml", "-f", *SWIMMERS, "--seconds", 75, "-o", "a.cambrian")
        self.assertEqual(self.rows("-r", "a.cambrian", "--seconds", 120), uncut[6:])
        self.assertIn("replay verified, 3 snapshots up to 120 s",
                      self.run_well("verify", "a.cambrian").stdout)
        for row in uncut:
            self.assertAlmostEqual(sum(row["energy"].values()), POND_ENERGY, places=5)
        self.write("torus.toml", POND + 'edges = "wraps"\n')
        self.assert_refused(self.run_program("preserve", "torus.toml"),
                            '[preserve] edges: unknown "wraps"; did you mean "wrap"?')

    def test_a_preserve_resumed_is_the_one_that_was_never_stopped(self):
        uncut = self.rows("pond.toml", "-f", *SWIMMERS, "--seconds", 120, "-o", "uncut.cambrian")
        first = self.rows("pond.toml", "-f", *SWIMMERS, "--seconds", 75, "-o", "a.cambrian")
        self.assertEqual(first, uncut[:7])
        rest = self.rows("--resume", "a.cambrian", "--seconds", 120)
        self.assertEqual(rest, uncut[6:])
        self.assertEqual(self.snapshots("a.cambrian"), self.snapshots("uncut.cambrian"))
        for option in ("--lives", "--series"):
            both = [self.run_well("export", name, option).stdout
                    for name in ("uncut.cambrian", "a.cambrian")]
            self.assertEqual(both[0], both[1])
        self.assertIn("replay verified, 3 snapshots up to 120 s",
                      self.run_well("verify", "a.cambrian").stdout)
        lives = list(csv.DictReader(self.run_well("export", "a.cambrian",
                                                  "--lives").stdout.splitlines()))
        for life in lives:
            self.assertRegex(life["uid"], "^[0-9a-f]{16}$")
        self.assertLessEqual({life["parent1"] for life in lives},
                             {"0", *(life["number"] for life in lives)})
        series = list(csv.DictReader(both[0].splitlines()))
        self.assertEqual(len(series), 12)
        self.assert_refused(self.run_program("preserve", "-r", "a.cambrian", "--seconds", 120),
                            "a.cambrian: has reached 120 s; --seconds T asks for more")

    def test_changed_laws_of_a_preserve_hold_after_a_stop_and_are_repeated(self):
        self.run_well("preserve", "pond.toml", "-f", *SWIMMERS, "--seconds", 1, "-o", "a.cambrian")
        for name in ("b.cambrian", "c.cambrian"):
            shutil.copy(self.folder / "a.cambrian", self.folder / name)
        laws = ["--law", "environment.viscosity-linear=0.6", "--law", "preserve.growth-time=400"]
        uncut = self.rows("-r", "a.cambrian", *laws, "--seconds", 120)
        unchanged = self.rows("-r", "b.cambrian", "--seconds", 60)
        self.assertNotEqual(uncut[:len(unchanged)], unchanged)
        pieces = [self.rows("-r", "c.cambrian", *more, "--seconds", end)
                  for more, end in ((laws, 60), ([], 120))]
        self.assertEqual(pieces[0] + pieces[1], uncut)
        self.assertEqual(self.snapshots("c.cambrian"), self.snapshots("a.cambrian"))
        for name in ("a.cambrian", "c.cambrian"):
            self.assertIn("replay verified, 3 snapshots up to 120 s",
                          self.run_well("verify", name).stdout)

    def test_a_law_that_cannot_be_changed_gets_one_message(self):
        self.run_well("preserve", "pond.toml", "-f", *SWIMMERS, "--seconds", 1, "-o", "a.cambrian")
        for law, message in {
                "preserve.growth-time=-1": "Growth time: -1 is not a number from 1 to 1000000 s",
                "preserve.restock=2.5": "2.5 is not a whole number from 0 to 1000 creatures",
                "preserve.width=20": 'there is no law "preserve.width" that can be changed',
                "preserve.growth-time=fast": "expected the name of a law and a number",
                "mutation.rate": "expected the name of a law and a number"}.items():
            refused = self.run_program("preserve", "-r", "a.cambrian", "--seconds", 60, "--law", law)
            self.assert_refused(refused, message)
            self.assertIn(f"--law {law}: ", refused.stderr)
        self.assert_refused(self.run_program("preserve", "pond.toml", "--law", "mutation.rate=2"),
                            "--law requires --resume")

    def test_the_museum_of_a_preserve_is_exported_as_creature_files(self):
        self.write("rich.toml", FERTILE)
        self.run_well("preserve", "rich.toml", "-f", *SWIMMERS, "--seconds", 1, "-o", "new.cambrian")
        self.assert_refused(self.run_program("export", "new.cambrian", "--museum", "-o", "museum"),
                            "the museum is empty")
        self.assert_refused(self.run_program("export", "new.cambrian", "--museum"), "--out FOLDER")
        self.run_well("preserve", "--resume", "new.cambrian", "--seconds", 60)
        names = self.run_well("export", "new.cambrian", "--museum", "-o", "museum").stdout.split()
        self.assertGreater(len(names), 0)
        self.assertEqual(sorted(names), sorted(file.name for file in
                                               (self.folder / "museum").iterdir()))
        for name in names:
            self.assertIn("lineage", name)
            world = json.loads((self.folder / "museum" / name).read_text())["world"]
            self.assertEqual(world["goal"]["behavior"], "swimming")
            self.assertFalse(world["environment"]["ground"])
            self.assertIn("BL/s", self.run_well("simulate", f"museum/{name}").stdout)
        self.assert_refused(self.run_program("export", "new.cambrian", "--museum", "-o", "museum"),
                            "expected a folder without such files")

    def test_a_killed_preserve_loses_at_most_a_minute_of_its_time(self):
        expected = self.rows("pond.toml", "-f", *SWIMMERS, "--seconds", 120)
        process = self.start("preserve", "pond.toml", "-f", *SWIMMERS, "-o", "a.cambrian", "--json",
                             stderr=subprocess.DEVNULL)
        seen = [json.loads(process.stdout.readline())["time"] for _ in range(8)]
        process.kill()
        process.wait(60)
        kept = self.snapshots("a.cambrian")[-1][0] / 60
        self.assertGreaterEqual(kept, seen[-1] - 60)
        rest = self.rows("-r", "a.cambrian", "--seconds", 120 if kept < 120 else kept + 60)
        if kept < 120:
            self.assertEqual(rest, expected[int(kept / 10):])
        self.assertIn("replay verified", self.run_well("verify", "a.cambrian").stdout)

    def test_a_changed_law_is_kept_though_the_minute_was_not_finished(self):
        self.run_well("preserve", "pond.toml", "-f", *SWIMMERS, "--seconds", 60, "-o", "a.cambrian")
        told = self.run_well("preserve", "-r", "a.cambrian", "--seconds", 70, "--law",
                             "preserve.growth-time=7")
        self.assertIn("goes on from the last full minute", told.stderr)
        self.run_well("preserve", "-r", "a.cambrian", "--seconds", 80)
        with opened(self.folder / "a.cambrian") as file:
            laws = file.execute("SELECT tick, x FROM interventions WHERE what LIKE 'law %'")
            self.assertEqual(laws.fetchall(), [(3600, 7.0)])
        self.run_well("verify", "a.cambrian")

    def test_a_damaged_snapshot_is_left_out_for_the_one_before(self):
        self.run_well("preserve", "pond.toml", "-f", *SWIMMERS, "--seconds", 120, "-o", "a.cambrian")
        kept = self.snapshots("a.cambrian")
        with opened(self.folder / "a.cambrian") as file:
            file.execute("UPDATE snapshots SET digest = digest + 1 WHERE tick = 7200")
        result = self.run_well("preserve", "--resume", "a.cambrian", "--seconds", 120)
        self.assertIn("the snapshot of 120 s is damaged", result.stderr)
        self.assertEqual(self.snapshots("a.cambrian"), kept)

    def test_what_a_preserve_cannot_use_gets_one_message(self):
        self.assert_refused(self.run_program("preserve"), "a settings file to begin with")
        self.assert_refused(self.run_program("preserve", "--founders", *SWIMMERS, "pond.toml"),
                            "pond.toml is behind --founders")
        self.write("hard.toml", POND + 'bodies = "hard"\n')
        self.assert_refused(self.run_program("preserve", "hard.toml"),
                            "known are solid, ghostly")
        self.assert_refused(self.run_program("evolve", "pond.toml"),
                            "these are the settings of a preserve")
        self.run_well("preserve", "pond.toml", "-f", *SWIMMERS, "--seconds", 1, "-o", "a.cambrian")
        self.assert_refused(self.run_program("preserve", "pond.toml", "-o", "a.cambrian"),
                            "File exists")
        self.assert_refused(self.run_program("evolve", "--resume", "a.cambrian"),
                            "it is a preserve, no experiment")
        self.assert_refused(self.run_program("export", "a.cambrian", "--champion"),
                            "it is a preserve, no experiment")
        older = self.run_well("preserve", "pond.toml", "-f", OLDER, "--seconds", 1)
        self.assertIn(f"{OLDER}: scored by simulator 0.9", older.stderr)
        self.write("small.toml", SMALL)
        self.run_well("evolve", "small.toml", "-n", 1, "-o", "e.cambrian")
        for command in (["preserve", "--resume", "e.cambrian"], ["export", "e.cambrian", "--lives"]):
            self.assert_refused(self.run_program(*command), "it is an experiment, no preserve")


if __name__ == "__main__":
    unittest.main()
