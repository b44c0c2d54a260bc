"""The JSON Schema of creature files accepts and rejects the same files as the reader."""

import json
import subprocess
import unittest

import jsonschema

from program import RANDOM_CREATURES, ROOT, ProgramTest

KEPT = ROOT / "tests/persist/creatures"
# Errors that a schema cannot express: invalid JSON, files that are too large or too deep, targets
# beyond the nodes, duplicate keys, numbers that JSON does not have, and too many keys.
BEYOND = ["E01", "E02", "E09", "E13", "E10_keys", "E07_overflow"]


def kept_schema(version=3):
    return (ROOT / f"assets/schema/creature-{version}.schema.json").read_text()


def schema(version=3):
    return json.loads(kept_schema(version))


class Schema(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.rules = jsonschema.Draft202012Validator(schema())
        cls.rules_of_space = jsonschema.Draft202012Validator(schema(4))

    def documents(self, begin):
        for path in sorted(KEPT.glob(begin + "*.creature.json")):
            if not any(path.name.startswith(name) for name in BEYOND):
                yield path.name, json.loads(path.read_text(encoding="utf-8-sig"))

    def test_the_kept_schemas_are_as_the_program_writes_them(self):
        self.assertEqual(self.run_well("schema").stdout, kept_schema())
        self.assertEqual(self.run_well("schema", "--dimensions", 3).stdout, kept_schema(4))
        for version in [3, 4]:
            jsonschema.Draft202012Validator.check_schema(schema(version))

    def test_the_sample_creatures_keep_to_the_schema(self):
        samples = sorted((ROOT / "assets/creatures").glob("*.creature.json"))
        self.assertGreaterEqual(len(samples), 10)
        for sample in samples:
            self.rules.validate(json.loads(sample.read_text()))

    def test_hundreds_of_random_creatures_keep_to_the_schema(self):
        """Three hundred without a fault mean that fewer than 1 % have one, at 95 % confidence."""
        for rules, others, dimensions in [(self.rules, self.rules_of_space, "2"),
                                          (self.rules_of_space, self.rules, "3")]:
            creatures = json.loads(
                subprocess.check_output([RANDOM_CREATURES, "300", dimensions]))
            self.assertEqual(len(creatures), 300)
            for creature in creatures:
                rules.validate(creature)
            self.assertFalse(others.is_valid(creatures[0]))

    def test_what_the_reader_loads_keeps_to_the_schema(self):
        for begin in ["sound", "W"]:
            for name, document in self.documents(begin):
                with self.subTest(name):
                    self.rules.validate(document)

    def test_what_the_reader_refuses_breaks_the_schema(self):
        codes = set()
        for name, document in self.documents("E"):
            if "trials_too" in name:
                continue  # a limit on several values together, which a schema cannot express
            with self.subTest(name):
                self.assertFalse(self.rules.is_valid(document))
            codes.add(name[:3])
        self.assertEqual(codes, {"E03", "E04", "E05", "E06", "E07", "E08", "E10", "E11", "E12"})

    def test_every_rule_is_explained(self):
        def explained(rules):
            for key, rule in rules.get("properties", {}).items():
                self.assertTrue(rule.get("description"), key)
                explained(rule)
            for each in rules.get("oneOf", []):
                explained(each)
        for version in [3, 4]:
            for rules in schema(version)["$defs"].values():
                explained(rules)


if __name__ == "__main__":
    unittest.main(verbosity=2)
