"""Creatures in three dimensions: swimmers and walkers evolve, replay, are traced and drawn; the rest is refused."""

import csv
import json
import unittest

from program import BAD_INPUT, ROOT, ProgramTest

SMALL_3D = """[goal]
behavior = "swimming"
[environment]
dimensions = 3
[run]
generations = 3
[population]
size = 12
[trial]
duration = 3
"""
WALK_3D = SMALL_3D.replace("swimming", "walking").replace("= 3\n[run]", "= 3\nself-contact = true\n[run]")
DART = ROOT / "assets/creatures/dart.creature.json"
WALKER = ROOT / "assets/creatures/walker.creature.json"


class Space(ProgramTest):
    def evolve(self, *options):
        self.write("swim.toml", SMALL_3D)
        return self.run_well("evolve", "swim.toml", *options)

    def refuse(self, words, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertIn(words, result.stderr)

    def test_swimmers_in_space_have_the_same_bytes_on_1_2_and_7_threads(self):
        outputs, creatures = set(), set()
        for threads in [1, 2, 7]:
            result = self.evolve("--threads", threads, "--out", "a.creature.json")
            outputs.add(result.stdout)
            creatures.add((self.folder / "a.creature.json").read_bytes())
        self.assertEqual((len(outputs), len(creatures)), (1, 1))
        creature = json.loads(creatures.pop())
        self.assertEqual((creature["version"], creature["dimensions"]), (4, 3))
        self.assertEqual(creature["scored"]["simulator"], "3d-0.3")
        self.assertEqual(creature["scored"]["environment"]["dimensions"], 3)

    def test_a_run_in_space_that_is_resumed_is_the_run_in_one_go(self):
        self.evolve("-n", 5, "-o", "whole.cambrian")
        self.evolve("-n", 2, "-o", "part.cambrian")
        self.run_well("evolve", "--resume", "part.cambrian", "-n", 5)
        for file in ["whole", "part"]:
            self.run_well("verify", f"{file}.cambrian")
            self.run_well("export", f"{file}.cambrian", "--champion", "-o", f"{file}.json")
        whole, part = ((self.folder / f"{file}.json").read_bytes() for file in ["whole", "part"])
        self.assertEqual(whole, part)
        self.assertIn("replay verified", self.run_well("verify", "whole.json").stdout)

    def test_a_planar_creature_is_lifted_and_swims_in_space(self):
        self.run_well("lift", DART, "-o", "dart.creature.json")
        score = json.loads(self.run_well("simulate", "dart.creature.json", "--json", "--trace",
                                         "dart.csv").stdout)
        self.assertGreater(score["fitness"], 0.1)
        self.assertEqual(score["verdict"], "clean")
        with open(self.folder / "dart.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0])[:4], ["time", "mass_x", "mass_y", "mass_z"])
        for row in rows:  # what was planar stays in its plane
            self.assertLess(abs(float(row["mass_z"])), 1e-9)
            turn = sum(float(row[f"part0_q{axis}"]) ** 2 for axis in "wxyz")
            self.assertAlmostEqual(turn, 1.0, places=6)

    def test_walkers_in_space_keep_their_bits_on_the_ground(self):
        self.write("walk.toml", WALK_3D)
        self.run_well("evolve", "walk.toml", "-n", 4, "-o", "whole.cambrian", "--threads", 2)
        self.run_well("evolve", "walk.toml", "-n", 2, "-o", "part.cambrian", "--threads", 1)
        self.run_well("evolve", "--resume", "part.cambrian", "-n", 4, "--threads", 3)
        for file in ["whole", "part"]:
            self.run_well("verify", f"{file}.cambrian")
            self.run_well("export", f"{file}.cambrian", "--champion", "-o", f"{file}.json")
        whole, part = ((self.folder / f"{file}.json").read_bytes() for file in ["whole", "part"])
        self.assertEqual(whole, part)
        self.assertIn("replay verified", self.run_well("verify", "whole.json").stdout)
        self.run_well("rescore", "whole.json", "--out", "again.creature.json")
        self.run_well("rescore", "whole.cambrian")
        score = json.loads(self.run_well("simulate", "whole.json", "--json", "--trace",
                                         "walk.csv").stdout)
        self.assertEqual(score["verdict"], "clean")
        self.assertLess(score["audit"]["max_penetration"], 0.01)
        self.assertLess(score["audit"]["contact_work"], 0.0)
        with open(self.folder / "walk.csv", encoding="utf-8") as file:
            heights = [float(row["mass_y"]) for row in csv.DictReader(file)]
        self.assertGreater(min(heights), 0.0)

    def test_a_planar_walker_is_lifted_onto_the_ground(self):
        self.run_well("lift", WALKER, "-o", "walker.creature.json", "--depth", 0.3)
        score = json.loads(self.run_well("simulate", "walker.creature.json", "--json").stdout)
        self.assertEqual((score["unit"], score["verdict"]), ("BL/s", "clean"))
        self.assertGreater(score["fitness"], 0.02)

    def test_settings_are_compared_in_space(self):
        self.write("swim.toml", SMALL_3D)
        self.write("tuned.toml", "[population]\ntuned = 0.8\n")
        arguments = ["compare", "--world", "swim.toml", "tuned.toml", "--random-search",
                     "--seeds", "1..2", "--trials", 24, "--out", "results"]
        report = self.run_well(*arguments).stdout
        for arm in ["tuned", "random-search"]:
            self.assertIn(f"| {arm} | 2 |", report)
        champion = next((self.folder / "results/champions").glob("*.json"))
        self.assertEqual(json.loads(champion.read_text())["dimensions"], 3)
        self.refuse("lives in 3 dimensions and", *arguments, "--world",
                    ROOT / "assets/settings/swimming.toml")

    def test_what_is_not_built_in_space_is_refused_in_one_sentence(self):
        self.write("swim.toml", SMALL_3D)
        for setting, words in [
                ("goal.behavior=flying", "flying is not built"),
                ("goal.behavior=seeking", "seeking is not built"),
                ("environment.light=true", "the light is not built"),
                ("body.organs.deformer=true", "organs are not built"),
                ("body.sensors.smell=true", "the sensor smell is not built"),
                ("body.strict-overlap=true", "the check of overlaps is not built")]:
            self.refuse(words, "evolve", "swim.toml", "--set", setting)
        self.refuse("this command does not work yet", "preserve", "swim.toml")
        self.refuse("lives in 3 dimensions", "evolve", "swim.toml", "--founders", DART)


if __name__ == "__main__":
    unittest.main()
