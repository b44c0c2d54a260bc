"""Settings at and beyond the ends of their ranges give a clear error or a finished run, and never
hang."""

import json
import math
import signal
import unittest

from program import FAILED, ProgramTest

# The ranges of all settings that influence a trial's motion: table, key, lowest, highest.
RANGES = [
    ("environment", "gravity", 0, 1000),
    ("environment", "gravity-direction", -180, 180),
    ("environment", "friction", 0, 100),
    ("environment", "elasticity", 0, 1),
    ("environment", "viscosity-linear", 0, 1e4),
    ("environment", "viscosity-quadratic", 0, 1e4),
    ("environment", "density", 1e-3, 1e4),
    ("simulation", "tolerance", 1e-8, 0.1),
    ("simulation", "contact-step", 1e-4, 1 / 60),
    ("simulation", "max-evaluations", 1e3, 1e6),
    ("simulation", "muscle-strength", 0, 1e4),
    ("simulation", "target-smoothing", 0, 10),
    ("simulation", "motor-speed-limit", 0, 100),
    ("simulation", "motor-frequency", 0.1, 200),
    ("trial", "duration", 0, 1e4),
    ("trial", "settle-limit", 0, 60),
]

# Creatures with the smallest and with the largest parts.
TINY = "[body]\nmin-length = 0.08\nmax-length = 0.08\nmin-width = 0.08\nmax-width = 0.08\n"
HUGE = ("[body]\nmin-length = 1.6\nmax-length = 1.6\nmin-width = 0.96\nmax-width = 0.96\n"
        "max-nodes = 16\nmax-parts = 32\n")


def settings(values, body=""):
    """Returns a settings file with these values; by default it has a short trial and few
    creatures."""
    tables = {"run": {"generations": 1}, "population": {"size": 4}, "trial": {"duration": 0.3}}
    for table, key, value in values:
        tables.setdefault(table, {})[key] = value
    lines = []
    for table, keys in tables.items():
        lines.append(f"[{table}]")
        lines.extend(f"{key} = {value}" for key, value in keys.items())
    return "\n".join(lines) + "\n" + body


class Extremes(ProgramTest):
    def test_a_setting_that_is_no_finite_number_is_refused(self):
        for table, key, low, high in RANGES:
            for value in ["nan", "inf", "-inf", "true", '"1"', "[1.0]"]:
                self.write("odd.toml", f"[{table}]\n{key} = {value}\n")
                result = self.run_program("evolve", "odd.toml")
                self.assert_refused(result, f"odd.toml: line 2, [{table}] {key}: ")
                if value in ["nan", "inf", "-inf"]:
                    self.assertIn(" is outside [", result.stderr)

    def test_a_setting_beyond_its_range_is_refused(self):
        for table, key, low, high in RANGES:
            for value in [math.nextafter(low, -math.inf), math.nextafter(high, math.inf), -1e308]:
                self.write("odd.toml", f"[{table}]\n{key} = {value!r}\n")
                self.assert_refused(self.run_program("evolve", "odd.toml"), "odd.toml: line 2",
                                    f"[{table}] {key}: {value!r}".split("e")[0], "is outside [")

    def test_every_setting_at_the_ends_of_its_range_is_run_to_an_end(self):
        for table, key, low, high in RANGES:
            for value in [low, high]:
                if key == "duration" and value == high:
                    continue
                self.write("end.toml", settings([(table, key, float(value))]))
                self.run_well("evolve", "end.toml", "--out", "end.json")

    def test_extremes_together_are_run_to_an_end(self):
        heavy = [("environment", "gravity", 1000), ("environment", "friction", 100),
                 ("environment", "elasticity", 1), ("environment", "density", 1e4)]
        treacle = [("environment", "viscosity-linear", 1e4), ("environment", "density", 1e-3),
                   ("environment", "viscosity-quadratic", 1e4)]
        ice = [("environment", "friction", 0), ("environment", "elasticity", 1),
               ("environment", "gravity", 0), ("environment", "gravity-direction", 90)]
        for values in [heavy, treacle, ice]:
            for body in [TINY, HUGE]:
                self.write("end.toml", settings(values, body))
                self.run_well("evolve", "end.toml", "--out", "end.json")
                report = json.loads(self.run_well("simulate", "end.json", "--json").stdout)
                self.assertTrue(math.isfinite(report["fitness"]))
                self.assertEqual(report["outcome"] == "completed", report["reason"] == "")

    def test_a_trial_over_its_work_limit_says_so(self):
        self.write("treacle.toml", settings([("environment", "viscosity-linear", 1e4),
                                             ("environment", "density", 1e-3)]))
        self.write("calm.toml", settings([]))
        self.run_well("evolve", "calm.toml", "--out", "a.json")
        report = self.run_well("simulate", "a.json", "--environment", "treacle.toml").stdout
        self.assertIn("over-budget (the motion is too stiff or too violent to compute", report)
        self.assertIn("more than 50000 evaluations a second", report)

    def test_ctrl_c_ends_a_trial_of_three_thousand_seconds(self):
        self.write("long.toml", settings([("trial", "duration", 3e3), ("population", "size", 300)]))
        process = self.start("evolve", "long.toml")
        self.wait_until_caught(process, signal.SIGINT)
        process.send_signal(signal.SIGINT)
        output, messages = process.communicate(timeout=60)
        self.assertEqual(process.returncode, FAILED)
        self.assertEqual(output, "")
        self.assertIn("interrupted before the first generation was judged", messages)
        self.assertEqual(self.files(), ["long.toml", "walking-seed1.cambrian"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
