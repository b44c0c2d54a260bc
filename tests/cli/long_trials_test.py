"""Long trials and experiments with many rows: memory, progress on a terminal, Ctrl+C."""

import json
import os
import pty
import re
import shutil
import signal
import subprocess
import threading
import unittest

from experiment_tables import opened
from program import BAD_INPUT, CAMBRIAN, DONE, FAILED, SMALL, ProgramTest

MOST_MEMORY = 300e6  # bytes

EMPTY_SPACE = """
[environment]
gravity = 0
ground = false
[trial]
duration = {duration}
stop-at-rest = false
[simulation]
max-evaluations = 19000
[body]
max-parts = 32
"""


def stiff_creature():
    """Returns a creature with at least 25 parts and only rigid joints: long to record, quick to
    compute."""
    def node(edges, target):
        return {"length": 0.3, "width": 0.1, "joint": "rigid", "limits": [-1.0, 1.0],
                "recursionLimit": 1, "symmetric": False, "mirrorAxis": "across",
                "effector": {"source": {"kind": "const"}, "weight": 1.0}, "neurons": [],
                "edges": [{"target": target, "pos": (i + 0.5) / edges, "angle": 0.0, "scale": 1.0,
                           "reflect": False, "terminalOnly": False} for i in range(edges)]}
    return json.dumps({"format": "cambrian-creature", "version": 1,
                       "nodes": [node(5, 1), node(5, 2), node(0, 0)], "brain": []})


class LongTrials(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("stiff.creature.json", stiff_creature())
        self.write("long.toml", EMPTY_SPACE.format(duration=5000))
        self.write("small.toml", SMALL)

    def test_a_trace_of_hours_takes_little_memory(self):
        self.assertLess(self.memory_of("simulate", "stiff.creature.json", "-e", "long.toml",
                                       "--trace", "/dev/null"), MOST_MEMORY)

    def test_a_trace_of_any_length_is_complete_or_not_there(self):
        self.write("minutes.toml", EMPTY_SPACE.format(duration=100))
        self.run_well("simulate", "stiff.creature.json", "-e", "minutes.toml", "--trace", "t.csv")
        rows = (self.folder / "t.csv").read_text().splitlines()
        self.assertEqual(len(rows), 6002)
        parts = rows[0].count(",") // 4
        self.assertGreaterEqual(parts, 25)
        self.assertEqual({row.count(",") for row in rows}, {2 + 4 * parts})
        disk = self.small_disk("1m")
        self.assert_refused(self.run_program("simulate", "stiff.creature.json", "-e", "long.toml",
                                             "--trace", "disk/t.csv"),
                            "No space left on device", status=FAILED)
        self.assertEqual(list(disk.iterdir()), [])

    def watched(self, *arguments, until, send=None):
        """Runs on a terminal and sends the signal when the text appears. Returns status and
        screen."""
        master, slave = pty.openpty()
        process = subprocess.Popen([CAMBRIAN, *arguments], cwd=self.folder,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=slave)
        os.close(slave)
        timer = threading.Timer(300, process.kill)
        timer.start()
        self.addCleanup(timer.cancel)
        shown = b""
        sent = False
        while True:
            try:
                chunk = os.read(master, 4096)
            except OSError:
                break
            if not chunk:
                break
            shown += chunk
            if send and not sent and re.search(until, shown.decode()):
                process.send_signal(send)
                sent = True
        os.close(master)
        return process.wait(), shown.decode()

    def test_a_long_trial_tells_how_far_it_is_and_ends_at_ctrl_c(self):
        champion = self.evolve_champion().name
        self.write("hours.toml", "[trial]\nduration = 10000\nstop-at-rest = false\n"
                                 "[simulation]\nmax-evaluations = 19000\n")
        before = self.files()
        for arguments, until in [
                (["simulate", champion, "-e", "hours.toml"], r"evaluating, 10000 s "),
                (["simulate", champion, "-e", "hours.toml", "--trace", "t.csv"],
                 r"tracing, 10000 s \[[#.]+\] \d+ %")]:
            status, shown = self.watched(*arguments, until=until, send=signal.SIGINT)
            self.assertRegex(shown, until)
            self.assertEqual(status, FAILED, shown)
            self.assertIn("cambrian: interrupted", shown)
            self.assertEqual(self.files(), before)

    # -- pictures

    def test_pictures_of_hours_take_little_memory(self):
        self.write("hours.toml", EMPTY_SPACE.format(duration=7200))
        for out, options in [("sheet.png", []),
                             ("clip.mp4", ["--fps", 1, "--speed", 20, "--size", "320x180"])]:
            commands = self.possible([["render", "stiff.creature.json", "-e", "hours.toml",
                                       "-o", out, *options]])
            for command in commands:
                if out.endswith(".mp4") and not shutil.which("ffmpeg"):
                    continue
                self.assertLess(self.memory_of(*command), MOST_MEMORY, out)
                self.assertTrue((self.folder / out).exists())

    # -- experiments

    def many_rows(self, name, rows, insert):
        self.run_well("evolve", "small.toml", "-n", 1, "-o", name)
        with opened(self.folder / name) as database:
            database.execute("PRAGMA journal_mode = DELETE")
            database.execute("BEGIN")
            insert(database, rows)
            database.execute("COMMIT")

    def test_settings_are_read_without_the_rest_of_the_experiment(self):
        self.run_well("evolve", "small.toml", "-n", 1, "-o", "plain.cambrian")
        expected = self.run_well("export", "plain.cambrian", "--settings").stdout
        for command in ["inject", "founder"]:
            def insert(database, rows, command=command):
                size, document = database.execute(
                    "SELECT size, document FROM genotypes LIMIT 1").fetchone()
                database.executemany(
                    "INSERT INTO journal (generation, command, size, genotype) VALUES (?, ?, ?, ?)",
                    ((0, command, size, document) for _ in range(rows)))
            name = command + ".cambrian"
            self.many_rows(name, 30000, insert)
            self.assertGreater((self.folder / name).stat().st_size, 10e6)
            self.assertEqual(self.run_well("export", name, "--settings").stdout, expected)
            for option in ["--settings", "--stats", "--champion"]:
                self.assertLess(self.memory_of("export", name, option), 200e6, (command, option))
            status = DONE if command == "inject" else FAILED  # other founders change the result
            self.assertLess(self.memory_of("verify", name, status=status), 200e6, command)

    def test_too_many_changes_of_settings_are_refused(self):
        def insert(database, rows):
            database.executemany("INSERT INTO settings VALUES (?, '')",
                                 ((i,) for i in range(2, rows)))
            database.executemany("INSERT INTO journal (generation, command, settings) "
                                 "VALUES (1, 'settings', ?)", ((i,) for i in range(2, rows)))
        self.many_rows("a.cambrian", 200000, insert)
        self.run_well("export", "a.cambrian", "--champion")
        for arguments in [["verify", "a.cambrian"], ["evolve", "-r", "a.cambrian", "-n", 4]]:
            self.assertLess(self.memory_of(*arguments, status=BAD_INPUT), 200e6)
            self.assert_refused(self.run_program(*arguments), "more than 5000 changes of settings")

    def test_commands_of_generations_that_never_were_are_refused(self):
        self.run_well("evolve", "small.toml", "-n", 2, "-o", "a.cambrian")
        with opened(self.folder / "a.cambrian") as database:
            database.execute("INSERT INTO journal (generation, command, share) "
                             "VALUES (3, 'newcomers', 0.5)")
        for arguments in [["verify", "a.cambrian"], ["evolve", "-r", "a.cambrian", "-n", 4]]:
            self.assert_refused(self.run_program(*arguments), "generation 3, which was never")


if __name__ == "__main__":
    unittest.main()
