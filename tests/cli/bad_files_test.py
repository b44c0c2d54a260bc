"""Files that are empty, truncated, of another kind, huge or malicious give one message and status
2."""

import unittest

from program import BAD_INPUT, ProgramTest


class BadFiles(ProgramTest):
    def refuse_creature(self, name, *parts):
        before = self.files()
        for arguments in [["simulate", name], ["simulate", name, "--trace", "t.csv"],
                          ["verify", name]]:
            self.assert_refused(self.run_program(*arguments), name, *parts)
        self.assertEqual(self.files(), before)

    def refuse_settings(self, name, *parts):
        before = self.files()
        self.assert_refused(self.run_program("evolve", name), name, *parts)
        self.assertEqual(self.files(), before)

    def test_a_missing_file_is_named(self):
        self.refuse_creature("none.creature.json", "No such file")
        self.refuse_settings("none.toml", "No such file")

    def test_a_folder_is_no_file(self):
        (self.folder / "folder").mkdir()
        self.refuse_creature("folder", "not a regular file")
        self.refuse_settings("folder", "not a regular file")

    def test_an_empty_creature_file_is_refused(self):
        self.write("empty.creature.json", "")
        self.refuse_creature("empty.creature.json", "the file is empty")

    def test_a_creature_file_cut_off_is_located(self):
        uncut = self.evolve_champion().read_bytes()
        for size in [1, len(uncut) // 2, len(uncut) - 3]:
            self.write("cut.creature.json", uncut[:size])
            self.refuse_creature("cut.creature.json", "E01 line ", "column ")

    def test_a_file_of_another_kind_is_refused(self):
        settings = self.write("small.toml", "[run]\nseed = 1\n").read_bytes()
        self.write("a.creature.json", settings)
        self.refuse_creature("a.creature.json", "E01 line 1")
        self.write("b.creature.json", b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 8)
        self.refuse_creature("b.creature.json", "expected a creature card")
        self.write("c.creature.json", '{"format": "geojson", "version": 1}')
        self.refuse_creature("c.creature.json", 'E03 /format: this is a "geojson"')
        self.write("d.toml", '{"format": "cambrian-creature", "version": 1}')
        self.refuse_settings("d.toml", "line 1")

    def test_a_file_of_100_megabytes_is_refused_at_once(self):
        for name in ["huge.creature.json", "huge.toml"]:
            with open(self.folder / name, "wb") as file:
                file.truncate(100_000_000)
        self.refuse_creature("huge.creature.json", "file too large: 100.0 MB, limit 4.0 MB")
        self.refuse_settings("huge.toml", "file too large: 100.0 MB, limit 1.0 MB")

    def test_numbers_that_are_none_are_refused(self):
        text = self.evolve_champion().read_text()
        start = text.index('"length": ') + len('"length": ')
        end = text.index(",", start)
        for number in ["NaN", "Infinity", "1e999", '"1"', "null"]:
            self.write("odd.creature.json", text[:start] + number + text[end:])
            self.refuse_creature("odd.creature.json", "E0")
        self.write("nan.toml", "[environment]\ngravity = nan\n")
        self.refuse_settings("nan.toml", "line 2, [environment] gravity: nan is outside")

    def test_deep_nesting_is_refused(self):
        self.write("deep.creature.json", "[" * 3_000_000)
        self.refuse_creature("deep.creature.json", "E02 nested deeper than 32 levels")
        self.write("deep.toml", "a = " + "[" * 500_000)
        self.refuse_settings("deep.toml", "line 1")

    def test_no_creature_file_takes_more_than_64_megabytes(self):
        size = 3_999_000
        idle = self.memory_of("simulate", "none.creature.json", status=BAD_INPUT)
        for name, begin, item, end in [
                ("lists", "[", "[],", "0]"), ("objects", "[", '{"a":{}},', "0]"),
                ("keys", "[", "{" + ",".join(f'"{i}":0' for i in range(250)) + "},", "0]"),
                ("texts", "[", '"0123456789abcdef0123456789abcdef",', "0]"),
                ("one text", '["', "\\u00e4", '"]'), ("one number", "[", "1", "]"),
                ("errors", '{"format": "cambrian-creature", "version": 1, "nodes": [', "{},", "0]}")]:
            self.write("big.creature.json", begin + item * ((size - 99) // len(item)) + end)
            with self.subTest(name):
                self.assertLess(self.memory_of("simulate", "big.creature.json",
                                                status=BAD_INPUT) - idle, 64e6)

    def test_a_mistyped_setting_stops_the_run(self):
        self.write("typo.toml", "[environment]\ngravty = 3\n")
        self.refuse_settings("typo.toml", 'line 2, [environment] gravty: unknown key; did you '
                                          'mean "gravity"?')

    def test_populations_and_runs_out_of_range_are_refused(self):
        for size in [-1, 0, 1, 20001, 10**9]:
            self.write("odd.toml", f"[population]\nsize = {size}\n")
            self.refuse_settings("odd.toml", f"line 2, [population] size: {size} is outside "
                                             "[2, 20000] creatures")
        self.write("odd.toml", "[run]\ngenerations = 1000000000\n")
        self.refuse_settings("odd.toml", "line 2, [run] generations: 1000000000 is outside "
                                         "[1, 1000000]")

    def test_crossed_limits_are_refused(self):
        for key, low, high in [("nodes", 6, 3), ("length", 1.5, 0.3), ("width", 0.9, 0.2)]:
            self.write("odd.toml", f"[body]\nmin-{key} = {low}\nmax-{key} = {high}\n")
            self.refuse_settings("odd.toml", f"[body] min-{key}: {low} is above max-{key}, which "
                                             f"is {high}")

    def test_shares_that_do_not_add_up_are_refused(self):
        self.write("odd.toml", "[breeding]\nasexual = 0.9\n")
        self.refuse_settings("odd.toml", "[breeding]: the shares add up to 1.5; they must add up "
                                         "to 1")

    def test_an_unknown_function_is_refused_with_those_there_are(self):
        self.write("odd.toml", "[body.functions]\nfrobnicate = true\n")
        self.refuse_settings("odd.toml", "line 2, [body.functions] frobnicate: unknown key; known "
                                         "are sum, product, ")

    def test_forbidding_all_references_is_refused(self):
        kinds = ["const", "localNeuron", "localSensor", "parentNeuron", "parentSensor",
                 "childNeuron", "childSensor", "brainNeuron", "partNeuron", "partSensor"]
        self.write("odd.toml", "[body.references]\n" + "".join(
            f"{kind} = false\n" for kind in kinds))
        self.refuse_settings("odd.toml", "[body.references]: joints would have nothing to follow")

    def test_an_overridden_setting_is_checked_like_a_written_one(self):
        self.write("empty.toml", "")
        result = self.run_program("evolve", "empty.toml", "--seed", "9" * 18)
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("--seed: 999999999999999999 is outside [0, 1e+15]", result.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
