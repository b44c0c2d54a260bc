"""Usage: help, versions and wrong arguments."""

import unittest

from program import BAD_INPUT, DONE, FAILED, ROOT, ProgramTest

SUBCOMMANDS = ["studio", "view", "evolve", "simulate", "render", "verify", "rescore", "lift",
               "settings", "worker", "cluster", "preserve", "compare", "export", "schema", "manual",
               "completion", "terrain"]


class CommandLine(ProgramTest):
    def test_help_names_every_subcommand(self):
        text = self.run_well("--help").stdout
        for name in SUBCOMMANDS:
            self.assertIn(name, text)

    def test_each_subcommand_explains_itself_with_an_example(self):
        for name in SUBCOMMANDS:
            text = self.run_well(name, "--help").stdout
            self.assertIn("Example:\n  cambrian " + name, text)

    def test_the_version_is_told(self):
        self.assertRegex(self.run_well("--version").stdout, r"^cambrian \d+\.\d+\.\d+\n$")

    def test_bad_usage_is_status_2_and_a_message(self):
        for arguments in [["fly"], ["evolve"], ["evolve", "--speed", "3", "a.toml"],
                          ["evolve", "a.toml", "--generations", "0"],
                          ["evolve", "a.toml", "--generations", "many"],
                          ["evolve", "a.toml", "--threads", "0"],
                          ["evolve", "a.toml", "--seed", "-1"], ["simulate"], ["verify"]]:
            result = self.run_program(*arguments)
            self.assertEqual(result.returncode, BAD_INPUT, arguments)
            self.assertNotEqual(result.stderr, "")
            self.assertEqual(result.stdout, "")

    def test_without_a_display_the_studio_says_so(self):
        environment = {"DISPLAY": "", "WAYLAND_DISPLAY": ""}
        result = self.run_program(env=environment)
        self.assertEqual(result.returncode, FAILED)
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertIn("cambrian evolve", result.stderr)

    def test_without_a_display_the_studio_can_evolve_instead(self):
        self.write("small.toml", "[run]\ngenerations = 2\n[population]\nsize = 6\n"
                                 "[trial]\nduration = 1\n")
        result = self.run_program("studio", "--if-no-display", "small.toml",
                                  env={"DISPLAY": "", "WAYLAND_DISPLAY": ""})
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 2)
        self.assertIn("without a window", result.stderr)
        self.assertIn("champion-walking-seed1.creature.json", self.files())

    def test_settings_are_written_complete_and_read_again(self):
        text = self.run_well("settings").stdout
        self.assertIn("gravity = 9.81 ", text)
        self.write("all.toml", text)
        self.assertEqual(self.run_well("settings", "all.toml").stdout, text)

    def test_the_sample_settings_are_as_the_program_writes_them(self):
        samples = sorted((ROOT / "assets/settings").glob("*.toml"))
        self.assertGreaterEqual(len(samples), 3)
        for sample in samples:
            kind = ["--preserve"] if "[preserve]" in sample.read_text() else []
            self.assertEqual(self.run_well("settings", sample, *kind).stdout, sample.read_text())

    def test_ground_of_others_becomes_settings_and_is_listed(self):
        self.write("stairs.csv", "-9,0\n2,0\n2,0.3\n9,0.5\n")
        self.run_well("terrain", "--import", "stairs.csv", "--out", "stairs.toml")
        points = self.run_well("terrain", "stairs.toml").stdout
        self.assertIn("2,0\n2,0.3\n9,0.5\n", points)
        self.assert_refused(self.run_program("terrain", ROOT / "assets/settings/walking.toml"),
                            "flat")
        self.write("back.csv", "0,0\n-1,0\n")
        self.assert_refused(self.run_program("terrain", "--import", "back.csv"), "point 2")

    def test_settings_of_a_goal_come_with_its_world(self):
        self.run_well("settings", "--goal", "swimming", "--out", "swim.toml")
        self.assertIn("gravity = 0.0 ", (self.folder / "swim.toml").read_text())
        self.assert_refused(self.run_program("settings", "--goal", "juggling"), "juggling",
                            "walking")


if __name__ == "__main__":
    unittest.main(verbosity=2)
