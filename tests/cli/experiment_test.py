"""Experiment files: saved during a run, resumed, exported, computed again, and after a crash."""

import json
import os
import random
import re
import signal
import subprocess
import time
import unittest

from experiment_tables import digests, opened
from program import DONE, FAILED, SMALL, ProgramTest

KILLS = int(os.environ.get("CAMBRIAN_KILLS", "12"))


class Experiment(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("small.toml", SMALL)

    def test_a_run_is_kept_beside_its_champion_unless_told_otherwise(self):
        self.run_well("evolve", "small.toml", "-n", 1)
        self.run_well("evolve", "small.toml", "-n", 1)
        self.assertEqual(self.files(), ["champion-walking-seed1-2.creature.json",
                                        "champion-walking-seed1.creature.json", "small.toml",
                                        "walking-seed1-2.cambrian", "walking-seed1.cambrian"])
        report = self.run_well("evolve", "small.toml", "-n", 1, "-o", "a.cambrian", "--json").stdout
        last = json.loads(report.splitlines()[-1])
        self.assertEqual((last["experiment"], last["champion"]), ("a.cambrian", None))
        self.run_well("evolve", "small.toml", "-n", 1, "-o", "b.creature.json")
        self.assertNotIn("b.cambrian", self.files())

    def test_two_runs_resumed_at_once_into_one_folder_keep_both_champions(self):
        for name in "ab":
            self.run_well("evolve", "small.toml", "-n", 1, "-o", f"{name}.cambrian")
        runs = [self.start("evolve", "--resume", f"{name}.cambrian", "-n", 20, "--out", "both/",
                           stderr=subprocess.DEVNULL) for name in "ab"]
        for run in runs:
            run.communicate(timeout=600)
            self.assertEqual(run.returncode, DONE)
        kept = sorted((self.folder / "both").iterdir())
        self.assertEqual(len(kept), 2, kept)
        for champion in kept:
            self.run_well("verify", champion)

    def journal(self, name):
        with opened(self.folder / name) as database:
            return [tuple(row) for row in database.execute(
                "SELECT generation, command FROM journal WHERE command != 'start' ORDER BY rowid")]

    def test_settings_change_and_creatures_join_where_a_run_is_resumed(self):
        self.run_well("evolve", "small.toml", "-n", 3, "-o", "a.cambrian")
        walker = self.evolve_champion("walker.creature.json")
        for name, threads in [("b.cambrian", 1), ("c.cambrian", 2)]:
            told = self.run_well(
                "evolve", "--resume", "a.cambrian", "--set", "environment.gravity=3.5", "--set",
                "mutation.rate=2", "--inject", walker, "-n", 6, "-t", threads, "-o", name).stderr
            self.assertEqual(told.count("environment.gravity: 3.5 m/s² instead of 9.81 m/s² from "
                                        "generation 3 on"), 1, told)
            self.assertEqual(self.journal(name), [(3, "settings"), (3, "inject")])
            self.run_well("verify", name)
        self.assertEqual(digests(self.folder / "b.cambrian"), digests(self.folder / "c.cambrian"))
        self.run_well("evolve", "--resume", "a.cambrian", "-n", 6, "-o", "uncut.cambrian")
        uncut = digests(self.folder / "uncut.cambrian")
        self.assertEqual(digests(self.folder / "b.cambrian")[:3], uncut[:3])
        self.assertNotEqual(digests(self.folder / "b.cambrian")[3:], uncut[3:])
        self.assertIn("gravity = 3.5", self.run_well("export", "b.cambrian", "--settings").stdout)

    def test_a_value_that_a_run_has_already_changes_nothing(self):
        self.run_well("evolve", "small.toml", "-n", 3, "-o", "a.cambrian")
        self.run_well("evolve", "--resume", "a.cambrian", "-n", 5, "-o", "b.cambrian")
        told = self.run_well("evolve", "--resume", "a.cambrian", "-n", 5, "--set",
                             "environment.gravity=9.81").stderr
        self.assertNotIn("gravity", told)
        self.assertEqual(self.journal("a.cambrian"), [])
        self.assertEqual(digests(self.folder / "a.cambrian"), digests(self.folder / "b.cambrian"))

    def test_a_setting_on_which_a_run_ends_can_be_changed(self):
        self.run_well("evolve", "small.toml", "-n", 2, "-o", "a.cambrian")
        self.run_well("evolve", "--resume", "a.cambrian", "--set", "run.generations=4")
        self.assertEqual(len(digests(self.folder / "a.cambrian")), 4)
        self.run_well("verify", "a.cambrian")

    def test_what_cannot_be_done_to_a_resumed_run_writes_nothing(self):
        self.run_well("evolve", "small.toml", "-n", 2, "-o", "a.cambrian")
        before = (self.folder / "a.cambrian").read_bytes()
        for options, part in [
                (("--set", "run.seed=9"), "run.seed cannot change during a run"),
                (("--set", "environment.gravity=-1"), "--set: "),
                (("--set", "gravitation=1"), "unknown setting"),
                (("--inject", "none.creature.json"), "none.creature.json"),
                (("--set", "environment.gravity=3"), "is complete with 2 generations")]:
            generations = () if "complete" in part else ("-n", 4)
            result = self.run_program("evolve", "--resume", "a.cambrian", *options, *generations)
            self.assert_refused(result, part)
            self.assertEqual((self.folder / "a.cambrian").read_bytes(), before)
        self.assert_refused(self.run_program("evolve", "small.toml", "--inject", "x.creature.json"),
                            "--inject", "--resume")

    def test_resumed_it_is_the_run_that_was_never_stopped(self):
        self.run_well("evolve", "small.toml", "-n", 20, "-t", 1, "-o", "uncut.cambrian")
        expected = digests(self.folder / "uncut.cambrian")
        self.assertEqual(len(expected), 20)
        self.run_well("evolve", "small.toml", "-n", 4, "-t", 2, "-o", "a.cambrian")
        self.run_well("evolve", "--resume", "a.cambrian", "-n", 13, "-t", 7)
        report = self.run_well("evolve", "-r", "a.cambrian", "-n", 20, "--json").stdout
        self.assertEqual(digests(self.folder / "a.cambrian"), expected)
        self.assertEqual(len(report.splitlines()), 8)
        for options in [["--champion"], ["--stats"], ["--settings"], ["-g", "7"]]:
            both = [self.run_well("export", name, *options).stdout
                    for name in ["uncut.cambrian", "a.cambrian"]]
            if "--settings" not in options:
                self.assertEqual(both[0], both[1])

    def test_what_is_exported_can_be_used(self):
        self.run_well("evolve", "small.toml", "-o", "a.cambrian")
        self.run_well("export", "a.cambrian", "--champion", "-o", "best.creature.json")
        self.assertIn("replay verified", self.run_well("verify", "best.creature.json").stdout)
        self.run_well("export", "a.cambrian", "--settings", "-o", "again.toml")
        self.run_well("evolve", "again.toml", "-n", 3, "-o", "b.cambrian")
        self.assertEqual(digests(self.folder / "a.cambrian"), digests(self.folder / "b.cambrian"))
        table = self.run_well("export", "a.cambrian", "--stats").stdout.splitlines()
        self.assertEqual(len(table), 4)
        self.assertTrue(table[0].startswith("generation,size,evaluations,best"))
        self.assert_refused(self.run_program("export", "a.cambrian", "-g", 3), "no generation 3")
        self.assert_refused(self.run_program("export", "a.cambrian"), "--champion, --generation G")

    def test_a_complete_run_is_computed_again_and_compared(self):
        self.run_well("evolve", "small.toml", "-o", "a.cambrian")
        self.assertIn("3 of 3 generations", self.run_well("verify", "a.cambrian").stdout)
        with opened(self.folder / "a.cambrian") as database:
            database.execute("UPDATE generations SET population_digest = 1 WHERE generation = 1")
        self.assert_refused(self.run_program("verify", "a.cambrian"),
                            "differs from generation 1 on", status=FAILED)

    def test_the_tables_answer_the_questions_of_the_help_page(self):
        self.run_well("evolve", "small.toml", "-n", 6, "-o", "a.cambrian")
        with opened(self.folder / "a.cambrian") as database:
            self.assertEqual(len(database.execute("SELECT * FROM champions").fetchall()), 6)
            line = database.execute(
                "WITH RECURSIVE line(id) AS (SELECT champion FROM generations WHERE generation = 5 "
                "UNION ALL SELECT mother FROM individuals JOIN line USING (id) "
                "WHERE mother IS NOT NULL) "
                "SELECT born, method FROM line JOIN individuals USING (id)").fetchall()
            self.assertEqual(line[-1], (0, "random"))
            self.assertEqual(sorted((born for born, _ in line), reverse=True),
                             [born for born, _ in line])

    def test_misuse_is_one_message(self):
        self.run_well("evolve", "small.toml", "-o", "a.cambrian")
        before = (self.folder / "a.cambrian").read_bytes()
        self.assert_refused(self.run_program("evolve", "small.toml", "-o", "a.cambrian"),
                            "a.cambrian", "File exists")
        self.assert_refused(self.run_program("evolve", "-r", "a.cambrian"), "--generations N")
        self.assert_refused(self.run_program("evolve", "-r", "small.toml"), "not an SQLite database")
        self.assert_refused(self.run_program("evolve", "-r", "none.cambrian"), "No such file")
        self.assert_refused(self.run_program("evolve"), "--resume")
        self.assert_refused(self.run_program("evolve", "small.toml", "-o", "no/a.cambrian"),
                            "No such file")
        self.assertEqual((self.folder / "a.cambrian").read_bytes(), before)

    def test_interrupted_it_says_how_to_go_on(self):
        process = self.start("evolve", "small.toml", "-n", "100000", "-o", "a.cambrian")
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        _, messages = process.communicate(timeout=600)
        self.assertEqual(process.returncode, DONE, messages)
        self.assertIn("cambrian evolve --resume a.cambrian", messages)
        kept = len(digests(self.folder / "a.cambrian"))
        self.run_well("evolve", "--resume", "a.cambrian", "-n", kept + 1)

    def test_a_file_in_use_is_refused(self):
        process = self.start("evolve", "small.toml", "-n", "100000", "-o", "a.cambrian")
        try:
            process.stdout.readline()
            self.assert_refused(self.run_program("evolve", "-r", "a.cambrian", "-n", "200000"),
                                "open in another window or program")
            self.run_well("export", "a.cambrian", "--champion")
        finally:
            process.kill()
            process.communicate()

    def test_removed_while_open_the_run_stops_with_a_message(self):
        process = self.start("evolve", "small.toml", "-n", "100000", "-o", "a.cambrian")
        process.stdout.readline()
        (self.folder / "a.cambrian").unlink()
        _, messages = process.communicate(timeout=600)
        self.assertEqual(process.returncode, FAILED)
        self.assertIn("removed or replaced", messages)

    def test_a_full_disk_loses_nothing_that_was_kept(self):
        disk = self.small_disk("600k")
        self.write("large.toml", SMALL.replace("size = 12", "size = 60"))
        result = self.run_program("evolve", "large.toml", "-n", 1000, "-o", "disk/a.cambrian")
        self.assertEqual(result.returncode, FAILED)
        self.assertIn("the disk is full", result.stderr)
        self.assertIn("--resume", result.stderr)
        kept = digests(disk / "a.cambrian")
        self.assertGreater(len(kept), 0)
        self.remount(disk, "size=20m")
        self.run_well("evolve", "-r", "disk/a.cambrian", "-n", len(kept) + 1)
        self.run_well("evolve", "large.toml", "-n", len(kept) + 1, "-o", "b.cambrian")
        self.assertEqual(digests(disk / "a.cambrian"), digests(self.folder / "b.cambrian"))

    def test_a_run_goes_on_past_what_ended_it_if_more_generations_are_asked_for(self):
        self.write("tiny.toml", SMALL.replace("duration = 2", "duration = 0.5"))
        self.run_well("evolve", "tiny.toml", "--set", "run.max-evaluations=15", "-n", 50,
                      "-o", "a.cambrian")
        kept = len(digests(self.folder / "a.cambrian"))
        self.assertLess(kept, 10)
        self.assert_refused(self.run_program("evolve", "-r", "a.cambrian"), "is complete")
        self.run_well("evolve", "-r", "a.cambrian", "-n", kept + 2)
        self.assertEqual(len(digests(self.folder / "a.cambrian")), kept + 2)

    def test_an_interrupted_run_says_how_to_go_on_as_it_was_begun(self):
        self.write("tiny.toml", SMALL.replace("duration = 2", "duration = 0.5"))
        (self.folder / "my runs").mkdir()
        process = self.start("evolve", "tiny.toml", "-n", 100000, "-o", "my runs/a.cambrian")
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        messages = process.communicate(timeout=600)[1]
        self.assertIn("cambrian evolve --resume 'my runs/a.cambrian'\n", messages)
        process = self.start("evolve", "-r", "my runs/a.cambrian", "-n", 200000)
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        messages = process.communicate(timeout=600)[1]
        self.assertIn("--resume 'my runs/a.cambrian' --generations 200000\n", messages)

    def test_killed_at_any_moment_it_goes_on_to_the_same_end(self):
        """Kills the program (kill -9) KILLS times before the last generation; each kill loses at
        most one generation. Kills before it has made its file are more, and come later on a slow
        machine."""
        self.write("tiny.toml", SMALL.replace("duration = 2", "duration = 0.5"))
        generations = 30 * KILLS
        chance = random.Random(7)
        fresh = ["tiny.toml", "-n", generations, "-o", "a.cambrian"]
        process = self.start("evolve", *fresh)
        kills, kept, latest = 0, 0, 0.35
        while kills < KILLS:
            time.sleep(chance.uniform(0.02, latest))
            reported = self.generation_when_killed(process)
            path = self.folder / "a.cambrian"
            if path.exists():
                kills += 1
                self.run_well("export", "a.cambrian", "--settings")
                now = len(digests(path))
                self.assertGreaterEqual(now, max(kept, reported))
                kept = now
                process = self.start("evolve", "-r", "a.cambrian", "-n", max(generations, kept + 1))
            else:
                self.assertEqual(kept, 0)
                latest *= 1.2
                process = self.start("evolve", *fresh)
        self.generation_when_killed(process)
        kept = len(digests(self.folder / "a.cambrian"))
        self.run_well("evolve", "-r", "a.cambrian", "-n", kept + 2)
        self.run_well("evolve", "tiny.toml", "-n", kept + 2, "-o", "uncut.cambrian")
        self.assertEqual(digests(self.folder / "a.cambrian"),
                         digests(self.folder / "uncut.cambrian"))
        self.assertEqual(self.run_well("export", "a.cambrian", "--champion").stdout,
                         self.run_well("export", "uncut.cambrian", "--champion").stdout)

    @staticmethod
    def generation_when_killed(process):
        """Kills the process. Returns the last generation that it told of, or 0."""
        process.kill()
        told = re.findall(r"^generation +(\d+)", process.communicate()[0], re.MULTILINE)
        return int(told[-1]) if told else 0



if __name__ == "__main__":
    unittest.main()
