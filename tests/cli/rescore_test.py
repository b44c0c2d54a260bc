"""cambrian rescore: creatures scored by another version of the simulator."""

import json
import shutil
import unittest

from experiment_tables import digests, opened
from program import DONE, FAILED, ROOT, SMALL, ProgramTest

# A creature with another motion in the simulator that scored it.
OLDER = ROOT / "tests/persist/versions/older_simulator/walker.creature.json"

# A file of version 1, which has numbers for the sensors' channels.
CHANNELS = ["joint", "contact-distal", "contact-left", "contact-proximal", "contact-right"]


def as_written_now(value):
    """Returns a document of version 1 with names in place of channel numbers."""
    if isinstance(value, list):
        return [as_written_now(each) for each in value]
    if not isinstance(value, dict):
        return value
    renewed = {key: as_written_now(each) for key, each in value.items()}
    if isinstance(value.get("ch"), int):
        renewed["ch"] = CHANNELS[value["ch"]]
    return renewed


class Rescore(ProgramTest):
    def older_creature(self, name="older.creature.json", change=lambda scored: None):
        creature = json.loads(OLDER.read_text())
        change(creature["scored"])
        return self.write(name, json.dumps(creature))

    def test_a_score_of_another_simulator_is_said_to_be_one(self):
        path = self.older_creature()
        for command in ["verify", "simulate"]:
            with self.subTest(command=command):
                result = self.run_program(command, path.name)
                self.assertIn("scored by simulator 0.9, this is ", result.stderr)
                self.assertIn("cambrian rescore", result.stderr)
        self.assertEqual(self.run_program("verify", path.name).returncode, FAILED)
        self.evolve_champion("own.creature.json")
        self.assertEqual(self.run_well("simulate", "own.creature.json").stderr, "")

    def test_a_rescored_creature_is_the_same_one_with_the_score_of_this_simulator(self):
        path = self.older_creature()
        before = as_written_now(json.loads(path.read_text())) | {"version": 2}
        told = self.run_well("rescore", path.name).stdout
        after = json.loads(path.read_text())
        scored = after["scored"]
        self.assertNotEqual(scored["simulator"], "0.9")
        self.assertNotEqual(scored["fitness"], before["scored"]["fitness"])
        self.assertRegex(told, r"older\.creature\.json: \S+ BL/s by simulator \S+, "
                               r"was \S+ BL/s by simulator 0\.9")
        changed = {"fitness", "simulator", "ticks", "trajectory", "recomputed"}
        for old, new in [(before, after), (before["scored"], scored)]:
            self.assertEqual({key for key in old.keys() | new.keys()
                              if old.get(key) != new.get(key)} - {"scored"},
                             changed if new is scored else set())
        self.assertEqual(self.run_well("verify", path.name).stderr, "")

    def test_a_creature_this_simulator_scored_keeps_its_file(self):
        path = self.evolve_champion()
        before = path.read_bytes()
        self.assertIn("unchanged", self.run_well("rescore", path.name).stdout)
        self.assertEqual(path.read_bytes(), before)

    def test_the_new_score_can_go_to_another_file(self):
        path = self.older_creature()
        before = path.read_bytes()
        self.run_well("rescore", path.name, "--out", "new.creature.json")
        self.assertEqual(path.read_bytes(), before)
        self.run_well("verify", "new.creature.json")
        self.assert_refused(self.run_program("rescore", path.name, path.name, "-o", "x.json"),
                            "--out is for one creature, found 2")
        self.assert_refused(self.run_program("rescore", path.name, "-o", "no/such/x.json"),
                            "no/such/x.json")

    def test_the_usual_integration_can_replace_the_files_own(self):
        def coarser(scored):
            scored["simulation"]["tolerance"] = 0.02
        path = self.older_creature(change=coarser)
        self.run_well("rescore", path.name, "-o", "own.creature.json")
        self.run_well("rescore", path.name, "-o", "usual.creature.json", "--default-integration")
        own, usual = [json.loads((self.folder / f"{name}.creature.json").read_text())["scored"]
                      for name in ["own", "usual"]]
        self.assertEqual(own["simulation"]["tolerance"], 0.02)
        self.write("all.toml", self.run_well("settings").stdout)
        self.assertIn(f'\ntolerance = {usual["simulation"]["tolerance"]} ',
                      (self.folder / "all.toml").read_text())
        self.assertNotEqual(own["trajectory"], usual["trajectory"])
        self.run_well("verify", "own.creature.json", "usual.creature.json")

    def test_one_file_that_cannot_be_used_does_not_stop_the_others(self):
        good = self.older_creature("good.creature.json")
        unscored = json.loads(OLDER.read_text())
        del unscored["scored"]
        unscored = self.write("unscored.creature.json", json.dumps(unscored))
        before = unscored.read_bytes()
        result = self.run_program("rescore", "missing.json", unscored.name, good.name)
        self.assertNotEqual(result.returncode, DONE)
        self.assertIn("missing.json", result.stderr)
        self.assertIn("unscored.creature.json: holds no score to replace", result.stderr)
        self.assertEqual(unscored.read_bytes(), before)
        self.run_well("verify", good.name)

    def test_a_creature_that_cannot_finish_its_trial_keeps_its_file(self):
        def starved(scored):
            scored["simulation"].update({"tolerance": 1e-8, "max-evaluations": 1000.0})
        path = self.older_creature(change=starved)
        before = path.read_bytes()
        result = self.run_program("rescore", path.name)
        self.assert_refused(result, "left as it is", "over-budget", status=FAILED)
        self.assertEqual(path.read_bytes(), before)


class RescoredExperiment(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("small.toml", SMALL)
        self.run_well("evolve", "small.toml", "-o", "a.cambrian")
        self.path = self.folder / "a.cambrian"

    def test_everyone_is_judged_again_in_the_next_generation_and_the_replay_holds(self):
        self.make_older()
        before = digests(self.path)
        told = self.run_well("rescore", "a.cambrian").stdout
        self.assertRegex(told, r"best of generation 3 (\S+) BL/s by simulator .*; "
                               r"best of generation 2 (\S+) BL/s by simulator \S+, now \2 BL/s")
        self.assertEqual(digests(self.path)[:-1], before)
        with opened(self.path) as database:
            survivors = database.execute("SELECT count(*) FROM individuals JOIN population "
                                         "ON id = individual WHERE born < 3").fetchone()[0]
            judged = database.execute("SELECT DISTINCT judged FROM population").fetchall()
        self.assertGreater(survivors, 0)
        self.assertEqual(judged, [(3,)])
        self.run_well("evolve", "--resume", "a.cambrian", "-n", 6)
        self.assertIn("6 of 6 generations, 1 commands",
                      self.run_well("verify", "a.cambrian").stdout)

    def test_an_experiment_of_this_simulator_is_left_as_it_is(self):
        before = self.path.read_bytes()
        self.assertIn("unchanged", self.run_well("rescore", "a.cambrian").stdout)
        self.assertEqual(self.path.read_bytes(), before)

    def test_an_experiment_of_another_simulator_says_so_until_it_is_rescored(self):
        self.make_older()
        self.assertEqual(self.champions_simulator(), "0.9")
        resumed = self.run_well("evolve", "--resume", "a.cambrian", "-n", 4)
        self.assertIn("scored by simulator 0.9, this is ", resumed.stderr)
        told = self.run_well("rescore", "a.cambrian").stdout
        self.assertIn("best of generation 4 ", told)
        self.assertNotEqual(self.champions_simulator(), "0.9")
        resumed = self.run_well("evolve", "--resume", "a.cambrian", "-n", 6)
        self.assertNotIn("0.9", resumed.stderr)

    def make_older(self):
        """Writes into the experiment that another simulator computed it."""
        with opened(self.path) as database:
            database.execute("UPDATE simulators SET version = '0.9'")

    def champions_simulator(self):
        exported = self.run_well("export", "a.cambrian", "--champion").stdout
        return json.loads(exported)["scored"]["simulator"]

    def test_misuse_changes_nothing(self):
        before = self.path.read_bytes()
        self.assert_refused(self.run_program("rescore", "a.cambrian", "--out", "b.creature.json"),
                            "--out and --default-integration are for creatures")
        self.assert_refused(self.run_program("rescore", "no.cambrian"), "no.cambrian")
        self.assertEqual(self.path.read_bytes(), before)


class RescoredCard(ProgramTest):
    def test_a_card_becomes_a_creature_file(self):
        shutil.copy(OLDER, self.folder / "older.creature.json")
        drawn = self.run_program("render", "older.creature.json", "-o", "older.card.png")
        if drawn.returncode != DONE:
            self.skipTest("cards cannot be drawn here")
        before = (self.folder / "older.card.png").read_bytes()
        self.assert_refused(self.run_program("rescore", "older.card.png"), "card", "--out")
        self.run_well("rescore", "older.card.png", "--out", "new.creature.json")
        self.run_well("verify", "new.creature.json")
        self.assertEqual((self.folder / "older.card.png").read_bytes(), before)


if __name__ == "__main__":
    unittest.main(verbosity=2)
