"""Challenges: frozen by the program, searched with their number of trials, entered on boards."""

import json
import pathlib
import re
import unittest

from program import BAD_INPUT, ROOT, ProgramTest

CHALLENGES = ROOT / "assets/challenges"
SETTINGS = """[population]
size = 20
[trial]
duration = 4
"""


class Challenge(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("hill.toml", SETTINGS)
        self.run_well("challenge", "new", "hill.toml", "--seed", 7, "--budget", 100, "-o",
                      "hill.challenge.toml")

    def evolved(self, *arguments):
        self.run_well("evolve", "hill.challenge.toml", *arguments)
        return next(self.folder.glob("*.creature.json"))

    def edited(self, path, name, change):
        creature = json.loads(path.read_text())
        change(creature)
        self.write(name, json.dumps(creature))
        return name

    def test_evolve_spends_the_number_of_trials_that_is_frozen(self):
        told = self.run_well("evolve", "hill.challenge.toml", "--json", "-o", "run.cambrian").stdout
        lines = [json.loads(line) for line in told.splitlines()]
        self.assertEqual(lines[0]["seed"], 7)
        trials = sum(line["evaluations"] for line in lines[:-1])
        self.assertGreaterEqual(trials, 100)
        self.assertLess(trials - lines[-2]["evaluations"], 100)

    def test_a_board_ranks_what_is_true_and_says_why_others_are_refused(self):
        best = self.evolved()
        champion = json.loads(best.read_text())
        self.run_well("export", next(self.folder.glob("*.cambrian")), "--generation", 0, "-o",
                      "first.creature.json")
        self.run_well("page", best, "-o", "its page.html")

        def fitter(creature):
            creature["scored"]["fitness"] *= 2

        def longer(creature):
            creature["nodes"][0]["length"] *= 1.01

        def renamed(creature):
            creature["name"] = "Another"
            creature["hue"] = 0.5

        def older(creature):
            creature["scored"]["simulator"] = "1.2"

        def unscored(creature):
            del creature["scored"]

        entries = {
            "fit.creature.json": (fitter, "scores "),
            "long.creature.json": (longer, "moves otherwise than its file says"),
            "copy.creature.json": (renamed, "is the creature of its page.html"),
            "old.creature.json": (older, "scored by simulator 1.2"),
            "none.creature.json": (unscored, "holds no score")}
        names = [self.edited(best, name, change) for name, (change, _) in entries.items()]
        walker = ROOT / "assets/creatures/walker.creature.json"
        self.write("text.creature.json", "no creature")
        result = self.run_well("challenge", "enter", "hill.challenge.toml", "first.creature.json",
                               "its page.html", *names, walker, "text.creature.json", "-o",
                               "board.md")
        self.assertIn("board.md: 2 ranked, 7 refused", result.stdout)
        for name, (_, reason) in entries.items():
            self.assertRegex(result.stderr, f"{name}: refused: .*{reason}")
        self.assertRegex(result.stderr, "walker.*another world: trial.duration is 15.0, .* 4.0")
        self.assertRegex(result.stderr, "text.creature.json: refused: ")
        board = (self.folder / "board.md").read_text()
        rows = re.findall(r"^\| (\d) \| \[?([^|\]]+?)\]?(?:\(([^)]*)\))? \| ([\d.]+)", board, re.M)
        self.assertEqual([row[0] for row in rows], ["1", "2"])
        self.assertEqual(rows[0][2], "its%20page.html")
        self.assertEqual(rows[0][3], f"{champion['scored']['fitness']:.3f}")
        self.assertGreater(float(rows[0][3]), float(rows[1][3]))

    def test_a_board_for_browsers_cannot_be_written_into(self):
        name = "</td><script>alert(1)</script>"
        best = self.evolved()
        evil = self.edited(best, "evil.creature.json", lambda creature: creature.update(name=name))
        self.run_well("challenge", "enter", "hill.challenge.toml", evil, "-o", "board.html")
        board = (self.folder / "board.html").read_text()
        self.assertNotIn("<script", board)
        self.assertIn("&lt;/td&gt;&lt;script&gt;alert(1)", board)
        for address in ["http:", "https:", "@import", "url("]:
            self.assertNotIn(address, board)
        self.assertIn("default-src 'none'", board)

    def test_what_is_no_challenge_of_this_program_is_refused(self):
        text = (self.folder / "hill.challenge.toml").read_text()
        edits = {
            "older.challenge.toml": (r'simulator = "[^"]*"', 'simulator = "0.9"',
                                     "the challenge is for simulator 0.9"),
            "nameless.challenge.toml": (r'name = "hill"', "name = 3", "expected a text"),
            "seedless.challenge.toml": (r"held-out-seed = \d+", "held-out-seed = -1",
                                        "expected a whole number"),
            "strange.challenge.toml": (r'name = "hill"', 'name = "hill"\nprize = 1',
                                       "unknown key")}
        for name, (old, new, reason) in edits.items():
            self.write(name, re.sub(old, new, text, count=1))
            for command in [["challenge", "enter", name, "hill.toml", "-o", "board.md"],
                            ["evolve", name]]:
                result = self.run_program(*command)
                self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
                self.assertIn(f"{name}: line ", result.stderr)
                self.assertIn(reason, result.stderr)
        result = self.run_program("challenge", "enter", "hill.toml", "hill.toml", "-o", "board.md")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("is no challenge but settings", result.stderr)
        result = self.run_program("challenge", "new", ROOT / "assets/settings/competition.toml",
                                  "-o", "contest.challenge.toml")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("depends on the opponent", result.stderr)
        self.assertEqual(list(self.folder.glob("*.md")) + list(self.folder.glob("contest*")), [])

    def test_the_boards_that_come_with_the_program_are_those_it_computes(self):
        found = sorted(CHALLENGES.glob("*.challenge.toml"))
        self.assertEqual(len(found), 5)
        for challenge in found:
            kept = pathlib.Path(str(challenge).replace(".challenge.toml", ".board.md"))
            names = re.findall(r"\| ([\w\\-]+\.creature\.json) \|", kept.read_text())
            self.assertGreaterEqual(len(names), 1, kept)
            entries = [self.place_of(name.replace("\\", "")) for name in names]
            result = self.run_well("challenge", "enter", challenge, *entries, "-o", "board.md")
            self.assertIn(" 0 refused", result.stdout)
            self.assertEqual((self.folder / "board.md").read_text(), kept.read_text(),
                             "`cambrian challenge enter` writes the board again")

    def place_of(self, name):
        for folder in [CHALLENGES, ROOT / "assets/creatures"]:
            if (folder / name).exists():
                return folder / name
        return self.fail(name)


if __name__ == "__main__":
    unittest.main()
