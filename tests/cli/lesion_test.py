"""Lesions of a creature, and its pruned twin."""

import csv
import json
import unittest

from program import BAD_INPUT, ROOT, ProgramTest

WALKER = ROOT / "assets/creatures/walker.creature.json"


class Lesion(ProgramTest):
    def test_lesions_are_listed_alike_in_each_form_and_on_any_threads(self):
        told = json.loads(self.run_well("lesion", WALKER, "--worlds", 3, "--json", "--threads", 1,
                                        "--csv", "x.csv").stdout)
        again = json.loads(self.run_well("lesion", WALKER, "--worlds", 3, "--json", "--threads",
                                         3).stdout)
        self.assertEqual(told, again)
        left = [row["fitness"] for row in told["lesions"]]
        self.assertEqual(left, sorted(left))
        kinds = {kind for row in told["lesions"] for kind in row["kinds"]}
        self.assertLessEqual({"lost-part", "limp-part", "locked-joint", "silent-neuron",
                              "cut-link"}, kinds)
        self.assertTrue(all(len(row["scores"]) == 3 for row in told["lesions"]))
        with open(self.folder / "x.csv", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual([row["lost"] for row in rows], [row["lost"] for row in told["lesions"]])
        text = self.run_well("lesion", WALKER, "--worlds", 3).stdout.splitlines()
        self.assertEqual(len(text), len(rows) + 1)

    def test_a_pruned_twin_is_verified_and_hardly_worse(self):
        told = json.loads(self.run_well("lesion", WALKER, "--json", "--prune",
                                        "twin.creature.json").stdout)
        self.assertGreaterEqual(told["pruned"]["after"], 0.99 * told["pruned"]["before"])
        self.assertIn("replay verified", self.run_well("verify", "twin.creature.json").stdout)
        twin = json.loads((self.folder / "twin.creature.json").read_text())
        self.assertEqual(twin["method"], "pruned")

    def test_pairs_follow_single_lesions(self):
        told = json.loads(self.run_well("lesion", WALKER, "--worlds", 1, "--pairs",
                                        "--json").stdout)
        self.assertEqual(sum(len(row["kinds"]) == 2 for row in told["lesions"]), 45)

    def test_creatures_in_space_have_lesions(self):
        self.run_well("lift", WALKER, "-o", "lifted.creature.json")
        told = json.loads(self.run_well("lesion", "lifted.creature.json", "--worlds", 1,
                                        "--json").stdout)
        self.assertGreater(len(told["lesions"]), 5)

    def test_mistakes_cost_nothing(self):
        result = self.run_program("lesion", WALKER, "--prune", "twin.toml")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertFalse((self.folder / "twin.toml").exists())
        self.assertEqual(self.run_program("lesion", WALKER, "--worlds", 0).returncode, BAD_INPUT)


if __name__ == "__main__":
    unittest.main()
