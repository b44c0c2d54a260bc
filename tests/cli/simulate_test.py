"""cambrian simulate and verify: a saved creature repeats its motion."""

import csv
import json
import unittest

from program import DONE, FAILED, ROOT, ProgramTest


class Simulate(ProgramTest):
    def test_a_champion_scores_again_what_its_file_says(self):
        creature = json.loads(self.evolve_champion().read_text())
        report = json.loads(
            self.run_well("simulate", "champion.creature.json", "--json").stdout)
        self.assertEqual(report["fitness"], creature["scored"]["fitness"])
        self.assertEqual(report["trajectory"], creature["scored"]["trajectory"])
        self.assertEqual(report["outcome"], "completed")

    def test_a_replay_is_verified(self):
        self.evolve_champion()
        result = self.run_well("verify", "champion.creature.json")
        self.assertIn("replay verified", result.stdout)

    def test_a_creature_changed_by_hand_is_found_out(self):
        path = self.evolve_champion()
        creature = json.loads(path.read_text())
        creature["scored"]["fitness"] += 1e-9
        path.write_text(json.dumps(creature))
        result = self.run_program("verify", path.name)
        self.assertEqual(result.returncode, FAILED)
        self.assertIn("the replay differs", result.stderr)

    def test_the_first_tick_that_differs_is_told(self):
        path = self.evolve_champion()
        creature = json.loads(path.read_text())
        scored = creature["scored"]
        scored["trajectory"] = "fnv1a64:0000000000000001"
        seconds = scored["ticks"]
        old = seconds[1][20:22]  # check byte of tick 71
        seconds[1] = seconds[1][:20] + ("00" if old != "00" else "01") + seconds[1][22:]
        path.write_text(json.dumps(creature))
        result = self.run_program("verify", path.name)
        self.assertEqual(result.returncode, FAILED)
        self.assertIn("the replay differs from tick 71 on", result.stderr)
        creature["scored"]["environment"]["gravity"] = 9.7
        path.write_text(json.dumps(creature))
        self.assertRegex(self.run_program("verify", path.name).stderr,
                         r"the replay differs from tick [1-9]\d* on")

    def test_a_creature_without_a_score_cannot_be_verified(self):
        path = self.evolve_champion()
        creature = json.loads(path.read_text())
        del creature["scored"]
        path.write_text(json.dumps(creature))
        self.assert_refused(self.run_program("verify", path.name), "holds no score")
        self.assertEqual(self.run_program("simulate", path.name).returncode, DONE)

    def test_any_trial_of_a_score_can_be_traced(self):
        dodger = str(ROOT / "assets/creatures/dodger.creature.json")
        ways = []
        for trial in ("1", "2"):
            self.run_well("simulate", dodger, "--trace", "motion.csv", "--trial", trial)
            with (self.folder / "motion.csv").open(newline="") as text:
                rows = list(csv.reader(text))
            ways.append(float(rows[-1][1]) - float(rows[1][1]))
        self.assertLess(ways[0] * ways[1], 0)  # the wall is on the other side
        self.assert_refused(self.run_program("simulate", dodger, "--trace", "motion.csv",
                                             "--trial", "5"), "combines 4 trials")
        self.assert_refused(self.run_program("simulate", dodger, "--trial", "2"), "--trace")

    def test_a_trace_has_a_row_a_tick_and_four_columns_a_part(self):
        self.evolve_champion()
        self.run_well("simulate", "champion.creature.json", "--trace", "motion.csv")
        with open(self.folder / "motion.csv", newline="") as file:
            rows = list(csv.reader(file))
        parts = json.loads(
            self.run_well("simulate", "champion.creature.json", "--json").stdout)["parts"]
        self.assertEqual(len(rows[0]), 3 + 4 * parts)
        self.assertEqual(len(rows), 1 + 2 * 60 + 1)  # header, the start, 2 s of ticks
        self.assertEqual(float(rows[1][0]), 0.0)
        self.assertAlmostEqual(float(rows[-1][0]), 2.0)
        self.assertTrue(all(len(row) == len(rows[0]) for row in rows))

    def test_a_trace_tells_where_the_light_is_and_how_far_parts_are_stretched(self):
        samples = ROOT / "assets/creatures"
        self.run_well("simulate", samples / "moth.creature.json", "--trace", "moth.csv")
        with open(self.folder / "moth.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        places = {(row["light_x"], row["light_y"]) for row in rows}
        self.assertEqual(len(places), 6)  # the first, then a jump at the start of each leg
        self.run_well("simulate", samples / "worm.creature.json", "--trace", "worm.csv")
        with open(self.folder / "worm.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertNotIn("light_x", rows[0])
        self.assertGreater(max(float(row["part0_stretch"]) for row in rows), 0.2)

    def test_what_is_left_without_senses_is_told(self):
        sample = ROOT / "assets/creatures/dodger.creature.json"
        text = self.run_well("simulate", sample, "--senses").stdout
        self.assertRegex(text, r"senses: 0\.0\d+ BL/s \(\d % of 0\.9\d*\) is left")
        self.assertIn("obstacle-left of part", text)
        report = json.loads(self.run_well("simulate", sample, "--senses", "--json").stdout)
        self.assertLess(report["senses"]["without_all"], 0.2 * report["senses"]["intact"])
        self.assertEqual({"sensor", "part", "constant", "fitness"},
                         set(report["senses"]["each"][0]))

    def test_a_creature_can_be_put_in_another_world(self):
        self.evolve_champion()
        self.write("moon.toml", "[environment]\ngravity = 1.62\n[trial]\nduration = 2\n")
        here = json.loads(self.run_well("simulate", "champion.creature.json", "--json").stdout)
        there = json.loads(self.run_well("simulate", "champion.creature.json", "--json",
                                         "--environment", "moon.toml").stdout)
        self.assertNotEqual(here["trajectory"], there["trajectory"])

    def test_a_champion_is_recomputed_before_it_is_saved(self):
        path = self.evolve_champion()
        creature = json.loads(path.read_text())
        recomputed = creature["scored"]["recomputed"]
        self.assertEqual(recomputed["outcome"], "completed")
        self.assertIn(recomputed["verdict"], ["clean", "suspect"])
        report = json.loads(self.run_well("simulate", path.name, "--json").stdout)
        self.assertEqual(report["recomputed"], recomputed)
        self.assertIn("computed more finely", self.run_well("simulate", path.name).stdout)
        self.assertIn("computed more finely", self.run_well("verify", path.name).stdout)
        creature["scored"]["recomputed"]["fitness"] += 1e-9
        path.write_text(json.dumps(creature))
        result = self.run_program("verify", path.name)
        self.assertEqual(result.returncode, FAILED)
        self.assertIn("computed more finely it differs", result.stderr)

    def test_a_report_tells_the_verdict_and_the_counters(self):
        self.evolve_champion()
        text = self.run_well("simulate", "champion.creature.json").stdout
        self.assertRegex(text, r"audit: (clean|suspect); muscles worked \S+ J; unexplained \S+ J")
        self.assertRegex(text, r"\d+ evaluations, \d+ steps, \d+ rejections, \d+ impacts, \d+ fall")
        report = json.loads(self.run_well("simulate", "champion.creature.json", "--json").stdout)
        self.assertIn(report["verdict"], ["clean", "suspect"])
        for counter in ["evaluations", "steps", "rejections", "events", "fallbacks"]:
            self.assertGreaterEqual(report["audit"][counter], 0)
        self.assertGreater(report["audit"]["evaluations"], report["audit"]["steps"])
        self.assertGreater(report["audit"]["max_part_speed"], 0)

    def test_every_integrator_can_be_chosen_in_a_file_or_on_the_command_line(self):
        walker = ROOT / "assets/creatures/walker.creature.json"
        trajectories = set()
        for name in ["bogacki-shampine", "dormand-prince", "cash-karp", "semi-implicit",
                     "least-squares"]:
            self.write("chosen.toml", f'[simulation]\nintegrator = "{name}"\n')
            common = ["simulate", walker, "--json"]
            asked = json.loads(self.run_well(*common, "--integrator", name).stdout)
            written = json.loads(self.run_well(*common, "--environment", "chosen.toml").stdout)
            self.assertEqual(asked["outcome"], "completed")
            self.assertEqual(asked["trajectory"], written["trajectory"])
            trajectories.add(asked["trajectory"])
        self.assertEqual(len(trajectories), 5)

    def test_an_unknown_integrator_is_refused_with_those_that_are_known(self):
        self.evolve_champion()
        result = self.run_program("simulate", "champion.creature.json", "--integrator", "euler")
        self.assert_refused(result, "[simulation] integrator", '"euler"', "dormand-prince")

    def test_a_trace_that_cannot_be_written_is_refused(self):
        self.evolve_champion()
        result = self.run_program("simulate", "champion.creature.json", "--trace", "no/such/t.csv")
        self.assert_refused(result, "cannot write no/such/t.csv")


if __name__ == "__main__":
    unittest.main(verbosity=2)
