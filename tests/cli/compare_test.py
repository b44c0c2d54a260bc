"""cambrian compare: evolution with several settings, and the report on their differences."""

import csv
import json
import signal
import subprocess
import time
import unittest

from program import FAILED, ProgramTest

QUICK = """
[goal]
behavior = "swimming"
[population]
size = 10
[trial]
duration = 1
"""


class Compare(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("quick.toml", QUICK)
        self.write("small.toml", "[population]\nsize = 5\n")

    def compare(self, *arguments):
        return self.run_well("compare", "-n", 15, *arguments)

    def rows(self, folder="comparison"):
        with open(self.folder / folder / "runs.csv", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_arms_are_compared_in_a_world(self):
        told = self.compare("-w", "quick.toml", "small.toml", "--random-search", "-s", "1..2,5",
                            "--out", "out")
        rows = self.rows("out")
        self.assertEqual({(row["arm"], row["seed"]) for row in rows},
                         {(arm, seed) for arm in ["small", "random-search"] for seed in "125"})
        for row in rows:
            self.assertGreaterEqual(int(row["evaluations"]), 15)
            name = (f"quick-{row['arm']}-seed{row['seed']}-{row['trials']}-"
                    f"{row['settings'][:8]}.creature.json")
            champion = json.loads((self.folder / "out" / "champions" / name).read_text())
            self.assertEqual(champion["scored"]["fitness"], float(row["score"]))
        self.assertIn("| small | 3 |", told.stdout)
        self.assertIn("random-search against small", told.stdout)
        self.assertEqual((self.folder / "out" / "report.md").read_text(), told.stdout)
        if "no curves are drawn" not in told.stderr:
            picture = (self.folder / "out" / "curves-quick.png").read_bytes()
            self.assertTrue(picture.startswith(b"\x89PNG"))

    def test_the_same_command_runs_nothing_twice(self):
        command = ["quick.toml", "--seeds", "1..2"]
        self.compare(*command)
        before = (self.folder / "comparison" / "runs.csv").read_bytes()
        again = self.compare(*command)
        self.assertNotIn("to do", again.stderr)
        self.assertEqual((self.folder / "comparison" / "runs.csv").read_bytes(), before)
        self.assertIn("1 run to do", self.compare("quick.toml", "--seeds", "1..3").stderr)

    def test_a_setting_is_swept(self):
        self.compare("quick.toml", "--sweep", "selection.method=rank,truncation", "--set",
                     "size=6", "-s", 1)
        self.assertEqual([row["arm"] for row in self.rows()],
                         ["selection.method=rank", "selection.method=truncation"])

    def test_an_interrupted_comparison_goes_on(self):
        command = ["compare", "quick.toml", "-n", "2000", "-s", "1..9", "-t", "1"]
        process = self.start(*command, stdout=subprocess.DEVNULL)
        table = self.folder / "comparison" / "runs.csv"
        while not table.exists() and process.poll() is None:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        message = process.communicate(timeout=600)[1]
        self.assertEqual(process.returncode, FAILED, message)
        self.assertIn("continues with the missing runs", message)
        done = self.rows()
        self.assertTrue(1 <= len(done) < 9)
        self.run_well(*command)
        self.assertEqual([row for row in self.rows() if row in done], done)
        self.assertEqual(len(self.rows()), 9)

    def test_bad_usage_is_told(self):
        for arguments, part in [
                ([], "expected settings files"),
                (["none.toml"], "none.toml"),
                (["quick.toml", "--seeds", "9..1"], "'9..1' is not a list of seeds"),
                (["quick.toml", "--seeds", "1..200"], "more than 100 seeds"),
                (["quick.toml", "--set", "gravty=3"], 'did you mean "gravity"?'),
                (["quick.toml", "--set", "gravity=deep"], "gravity"),
                (["quick.toml", "--set", "gravity"], "expected a setting and its value"),
                (["quick.toml", "--sweep", "gravity"], "--sweep"),
                (["quick.toml", "quick.toml"], 'two are called "quick"'),
                (["-w", "quick.toml", "quick.toml", "--set", "gravity=1"],
                 "changes the goal or the environment"),
                (["quick.toml", "-n", "0"], "0")]:
            with self.subTest(arguments):
                self.assert_refused(self.run_program("compare", *arguments), part)
        self.assertFalse((self.folder / "comparison").exists())

    def test_a_foreign_table_is_left_alone(self):
        (self.folder / "mine").mkdir()
        self.write("mine/runs.csv", "a,b\n1,2\n")
        self.assert_refused(self.run_program("compare", "quick.toml", "-o", "mine"),
                            "line 1: expected a table of compared runs")
        self.assertEqual((self.folder / "mine" / "runs.csv").read_text(), "a,b\n1,2\n")


class TypedSettings(ProgramTest):
    def test_a_trial_is_repeated_in_worlds_a_hair_different(self):
        self.evolve_champion()
        command = ["simulate", "champion.creature.json", "--json"]
        once = json.loads(self.run_well(*command).stdout)
        many = json.loads(self.run_well(*command, "--repeat", 4).stdout)
        self.assertEqual(once["repeated"], [])
        self.assertEqual(len(many["repeated"]), 4)
        self.assertEqual(once["fitness"], many["fitness"])
        self.assertGreater(len(set(many["repeated"])), 1)
        same = self.run_well(*command, "--repeat", 4, "--set", "confirm-jitter=0", "--set",
                             "confirm-tilt=0").stdout
        self.assertLessEqual(len(set(json.loads(same)["repeated"])), 2)  # the first one is finer
        told = self.run_well("simulate", "champion.creature.json", "--repeat", 4).stdout
        self.assertRegex(told, r"in 4 slightly different worlds: median \S+ BL/s, \S+ to \S+")

    def test_settings_of_a_trial_are_typed(self):
        self.evolve_champion()
        self.write("moon.toml", "[environment]\ngravity = 1.62\n[trial]\nduration = 2\n"
                                "[simulation]\ntolerance = 1e-5\n")
        command = ["simulate", "champion.creature.json", "--json"]
        typed = self.run_well(*command, "--set", "environment.gravity=1.62", "--tolerance", "1e-5")
        self.assertEqual(json.loads(typed.stdout)["trajectory"], json.loads(
            self.run_well(*command, "-e", "moon.toml").stdout)["trajectory"])
        self.assert_refused(self.run_program(*command, "--tolerance", "5"), "tolerance")
        self.assert_refused(self.run_program(*command, "--set", "duration"), "expected a setting")

    def test_one_command_evolves_several_seeds(self):
        self.write("quick.toml", QUICK + "[run]\ngenerations = 2\n")
        told = self.run_well("evolve", "quick.toml", "--seeds", "3..4,9", "--set", "size=6", "-o",
                             "out/", "--json").stdout
        generations = [line for line in map(json.loads, told.splitlines()) if "size" in line]
        self.assertEqual([line["seed"] for line in generations], [3, 3, 4, 4, 9, 9])
        self.assertEqual(sorted(path.name for path in (self.folder / "out").glob("*.cambrian")),
                         [f"swimming-seed{seed}.cambrian" for seed in (3, 4, 9)])
        statistics = self.run_well("export", "out/swimming-seed9.cambrian", "--stats").stdout
        rows = list(csv.DictReader(statistics.splitlines()))
        self.assertEqual([row["size"] for row in rows], ["6", "6"])
        self.assertEqual(int(rows[1]["trials"]),
                         int(rows[0]["evaluations"]) + int(rows[1]["evaluations"]))
        refused = self.run_program("evolve", "quick.toml", "--seeds", "1,2", "-o", "a.cambrian")
        self.assert_refused(refused, "several seeds need a folder")
        self.assert_refused(self.run_program("evolve", "quick.toml", "--seeds", "x"),
                            "'x' is not a list of seeds")


if __name__ == "__main__":
    unittest.main()
