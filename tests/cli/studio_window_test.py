"""The studio in a real X window with mouse and keyboard input."""

import csv
import contextlib
import json
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import time
import unittest

from experiment_tables import digests
from program import CAMBRIAN, ROOT, SMALL
from studio_driver import PICTURES, StudioTest

KILLS = int(os.environ.get("CAMBRIAN_KILLS", "4"))


class StudioWindow(StudioTest):
    def test_a_person_evolves_pauses_saves_quits_and_comes_back(self):
        self.write("small.toml", SMALL)
        display = self.open_display()
        self.start(display, "small.toml")
        self.click("Evolve")
        self.wait_for("running")
        _, after = self.wait_for("generation", number=1)
        self.press("space")
        self.wait_for("paused", after=after)
        self.assertNotIn(os.SCHED_IDLE, self.schedulers())
        self.assert_painted(display.picture("evolved-1280x800.png"))
        saved = self.save_as("ctrl+s", "kept")
        self.assertEqual(saved, self.folder / "kept.creature.json")
        self.quit()
        self.run_well("verify", "kept.creature.json")

        self.start(display, "kept.creature.json", priority="background")
        loaded, _ = self.wait_for("loaded")
        self.assertIn("kept.creature.json", loaded["path"])
        self.wait_for("shown")
        self.press("g")
        self.wait_for("generation", number=0)
        self.assertIn(os.SCHED_IDLE, self.schedulers())
        self.quit()

    def test_a_signal_closes_the_window_as_a_person_would(self):
        display = self.open_display(painted=False)
        for asked in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            self.start(display)
            self.studio.send_signal(asked)
            self.assertEqual(self.studio.wait(60), 0, asked)
            self.wait_for("quit")

    def test_a_gene_is_edited_undone_made_again_and_saved(self):
        self.write("small.toml", SMALL)
        display = self.open_display()
        self.start(display, "small.toml")
        self.press("g")
        shown, _ = self.wait_for("shown", title="Champion of generation 0")
        self.assertRegex(shown["name"], "^[A-Z][a-z]{5,}$")
        self.click("Genotype")
        self.type_into("part 0 length", "1.25")
        edited, after = self.wait_for("gene edited", place="part 0 length", to="1.25 m")
        display.tool("key", "ctrl+z")
        _, after = self.wait_for("gene undone", after=after)
        display.tool("key", "ctrl+shift+z")
        self.wait_for("gene redone", after=after)
        self.type_into("part 0 width", "7")
        refused, _ = self.wait_for("notice", problem=True)
        self.assertIn("7 is not allowed here", refused["text"])
        self.assert_painted(display.picture("genotype-1280x800.png"))
        display.tool("key", "ctrl+s")
        self.type_over(str(self.folder / "edited"))
        display.tool("key", "Return")
        self.wait_for("saved")
        self.quit()
        saved = json.loads((self.folder / "edited.creature.json").read_text())
        self.assertEqual(saved["method"], "edited")
        self.assertEqual(saved["parents"], [shown["uid"]])
        self.assertEqual(saved["nodes"][0]["length"], 1.25)
        self.assertNotEqual(edited["from"], "1.25 m")
        self.run_well("verify", "edited.creature.json")

    def test_the_timeline_is_scrubbed_and_exported(self):
        self.write("small.toml", SMALL)
        display = self.open_display()
        self.start(display, "small.toml", "--evolve")
        self.wait_for("generation", number=11)
        self.press("space")
        _, after = self.wait_for("paused")
        self.drag("timeline", 0.9, -0.1)
        _, after = self.wait_for("shown", after=after, title="Champion of generation 0")
        self.press("Right")
        _, after = self.wait_for("shown", after=after, title="Champion of generation 1")
        self.press("k")
        self.wait_for("starred", after=after)
        self.assert_painted(display.picture("scrubbed-1280x800.png"))
        self.press("n")
        last = max(event["number"] for event in self.events() if event["event"] == "generation")
        self.wait_for("shown", after=after, title=f"Champion of generation {last:.0f}")
        table = self.save_as("ctrl+e", "run")
        self.assertEqual(table, self.folder / "run.csv")
        self.assert_table_tells_what_happened(table)
        plot = self.save_as("ctrl+shift+e", "plot")
        size = subprocess.run(["identify", "-format", "%w %h %k", str(plot)], check=True,
                              stdout=subprocess.PIPE, encoding="utf-8").stdout.split()
        self.assertEqual(size[:2], ["1280", "720"])
        self.assertGreater(int(size[2]), 16)
        self.quit()

    def assert_table_tells_what_happened(self, table):
        with table.open(newline="") as file:
            rows = list(csv.DictReader(file))
        generations = [event for event in self.events() if event["event"] == "generation"]
        self.assertEqual([int(row["generation"]) for row in rows],
                         [event["number"] for event in generations])
        for row, event in zip(rows, generations):
            self.assertAlmostEqual(float(row["best"]), event["best"], delta=1e-6)
            self.assertEqual(int(row["size"]), 12)

    def test_a_person_picks_breeds_goes_back_branches_and_saves(self):
        self.write("small.toml", SMALL)
        display = self.open_display()
        self.start(display, "small.toml")
        self.press("g")
        self.wait_for("generation", number=0)
        self.wait_for("paused")
        self.click("Hand-pick")
        self.wait_for("hand-picking", on=True)
        first, after = self.wait_for("grid", number=0)
        self.assertEqual(first["origin"], "chosen from the population")
        for count, cell in enumerate(["cell 2", "cell 5", "cell 7"], start=1):
            self.click(cell)
            _, after = self.wait_for("picks", after=after, count=count)
        display.picture("hand-pick-1280x800.png")
        self.press("Return")
        _, after = self.wait_for("grid", after=after, number=1, parent=0,
                                 origin="bred from 3 picks")
        self.press("BackSpace")
        _, after = self.wait_for("grid", after=after, number=0)
        self.press("Delete")
        _, after = self.wait_for("picks", after=after, count=0)
        self.press("4")
        _, after = self.wait_for("picks", after=after, count=1)
        self.press("Return")
        branch, after = self.wait_for("grid", after=after, number=2)
        self.assertEqual((branch["parent"], branch["origin"], branch["grids"]),
                         (0, "bred from 1 pick", 3))
        self.assert_painted(display.picture("hand-pick-branch-1280x800.png"))
        self.press("s")
        self.type_over(str(self.folder / "picked"))
        display.tool("key", "Return")
        saved, _ = self.wait_for("saved", after=after)
        self.assertEqual(saved["path"], str(self.folder / "picked.creature.json"))
        self.press("h")
        self.wait_for("hand-picking", after=after, on=False)
        self.quit()
        self.run_well("verify", "picked.creature.json")

    def test_an_experiment_steered_by_hand_comes_back_and_is_the_same_again(self):
        """The window is closed in the middle of a generation. The next one has the settings,
        champions and picking tree, and the journal gives the same bits."""
        state = self.folder / "state"
        self.write("small.toml", SMALL)
        display = self.open_display(painted=False)
        self.start(display, "small.toml")
        self.click("Evolve")
        _, after = self.wait_for("generation", number=1)
        self.type_into("environment.gravity", "1.62")
        _, after = self.wait_for("edited", field="environment.gravity")
        steered, _ = self.wait_for("generation", after=after)
        self.wait_for("generation", after=after, number=steered["number"] + 2)
        self.quit()
        with contextlib.closing(sqlite3.connect(state / "experiment.cambrian")) as database:
            changes = database.execute("SELECT generation, toml FROM journal JOIN settings ON "
                                       "settings.id = settings WHERE command = 'settings'"
                                       ).fetchall()
        self.assertEqual(len(changes), 1)
        self.assertIn("gravity = 1.62", changes[0][1])
        verified = self.run_well("verify", state / "experiment.cambrian").stdout
        self.assertIn("1 commands on the way", verified)

        self.start(display)
        back, after = self.wait_for("experiment")
        self.assertGreaterEqual(back["generations"], steered["number"] + 2)
        self.press("h")
        _, after = self.wait_for("grid", after=after, number=0)
        self.click("cell 2")
        _, after = self.wait_for("picks", after=after, count=1)
        self.press("Return")
        _, after = self.wait_for("grid", after=after, number=1, parent=0)
        self.click("cell 3")
        _, after = self.wait_for("picks", after=after, count=1)
        display.tool("key", "ctrl+k")
        self.type_over(str(self.folder / "mine"))
        display.tool("key", "Return")
        self.wait_for("saved", after=after)
        self.quit()

        self.start(display, str(self.folder / "mine.cambrian"))
        again, after = self.wait_for("experiment")
        self.assertEqual(again["generations"], back["generations"])
        self.press("h")
        grid, after = self.wait_for("grid", after=after)
        self.assertEqual((grid["number"], grid["grids"]), (1, 2))
        self.wait_for("picks", count=1)
        self.press("BackSpace")
        self.wait_for("grid", after=after, number=0)
        self.press("h")
        self.click("Evolve")
        self.wait_for("generation", number=again["generations"])
        self.quit()

    def test_a_window_killed_at_any_moment_loses_one_generation_at_most(self):
        kept_file = self.folder / "state" / "experiment.cambrian"
        self.write("small.toml", SMALL)
        display = self.open_display(painted=False)
        self.start(display, "small.toml")
        self.click("Evolve")
        self.wait_for("generation", number=1)
        chance = random.Random(3)
        for kill in range(KILLS):
            time.sleep(chance.uniform(0, 1.5))
            told = [event["number"] for event in self.events() if event["event"] == "generation"]
            self.studio.kill()
            self.studio.wait()
            kept = digests(kept_file)
            self.assertGreaterEqual(len(kept), max(told, default=0) + 1)
            if kill % 4 == 3:  # again while it opens the file
                self.start_and_kill(display, chance.uniform(0, 0.4))
                self.assertEqual(digests(kept_file), kept)
            self.start(display)
            back, _ = self.wait_for("experiment")
            self.assertEqual(back["generations"], len(kept))
            self.press("space")
            self.wait_for("running")
        self.quit()
        kept = digests(kept_file)
        self.run_well("evolve", "small.toml", "-n", len(kept), "-o", "uncut.cambrian")
        self.assertEqual(digests(self.folder / "uncut.cambrian"), kept)

    def test_a_full_disk_pauses_the_window_and_loses_nothing(self):
        state = self.small_disk("700k", "state")
        (state / "view.conf").write_text("tour-taken = yes\n")
        self.write("large.toml", SMALL.replace("size = 12", "size = 60"))
        display = self.open_display()
        self.start(display, "large.toml")
        self.click("Evolve")
        notice, after = self.wait_for("notice", problem=True)
        self.assertIn("the disk is full", notice["text"])
        self.display.wait_for_frames(4)
        self.assert_painted(display.picture("full-disk-1280x800.png"))
        kept = len(digests(state / "experiment.cambrian"))
        self.assertGreater(kept, 0)
        self.remount(state, "size=50m")
        self.press("space")
        self.wait_for("generation", after=after, number=kept + 2)
        self.quit()
        kept = digests(state / "experiment.cambrian")
        self.run_well("evolve", "large.toml", "-n", len(kept), "-o", "uncut.cambrian")
        self.assertEqual(digests(self.folder / "uncut.cambrian"), kept)

    def start_and_kill(self, display, after):
        studio = subprocess.Popen(
            [CAMBRIAN, "studio", "--state-dir", self.folder / "state", "--threads", "1"],
            cwd=self.folder, env=display.environment, stderr=subprocess.DEVNULL)
        time.sleep(after)
        studio.kill()
        studio.wait()

    def test_a_damaged_file_is_a_message_and_the_studio_goes_on(self):
        self.write("cut.creature.json", '{"format": "cambrian-creature", "ver')
        display = self.open_display()
        self.start(display, "cut.creature.json")
        notice, _ = self.wait_for("notice", problem=True)
        self.assertIn("cut.creature.json", notice["text"])
        self.assertIn("line 1", notice["text"])
        self.assertNotIn("E01", notice["text"])
        self.assertIn("Nothing was opened", notice["text"])
        display.tool("key", "g")
        self.wait_for("running")
        self.assert_painted(display.picture("damaged-file-1280x800.png"))
        self.quit()

    def test_a_creature_becomes_a_card_and_comes_back_from_it(self):
        walker = ROOT / "assets/creatures/walker.creature.json"
        display = self.open_display()
        self.start(display, walker)
        self.display.tool("key", "ctrl+s")
        self.click("Card")
        self.display.wait_for_frames(4)
        self.assert_painted(display.picture("save-card-1280x800.png"))
        display.tool("key", "Escape")
        card = self.save_as("ctrl+s", "posted.card.png")
        self.assertEqual(card, self.folder / "posted.card.png")
        self.quit()
        self.assertIn("replay verified", self.run_well("verify", card).stdout)
        shutil.copy(card, PICTURES / "saved-card.png")

        self.start(display, card)
        loaded, _ = self.wait_for("loaded")
        self.assertEqual(loaded["path"], str(card))
        self.assert_painted(display.picture("opened-card-1280x800.png"))
        self.quit()

    def test_settings_of_a_goal_open_with_the_founders_of_their_run(self):
        display = self.open_display()
        for goal in ("swimming", "flying"):
            self.start(display, ROOT / f"assets/settings/{goal}.toml")
            founders, _ = self.wait_for("founders")
            self.assertEqual(founders["count"], 20)
            self.assert_painted(display.picture(f"{goal}-settings-1280x800.png"))
            self.quit()

    def test_the_viewer_shows_one_creature_and_nothing_else(self):
        display = self.open_display()
        self.open_window(display, "view", ROOT / "assets/creatures/hopper.creature.json")
        self.assertEqual(display.tool("getwindowname", self.window).strip(), "Hopper – Cambrian")
        self.wait_for("place", name="viewport")
        names = {event["name"] for event in self.events() if event["event"] == "place"}
        self.assertIn("Restart", names)
        self.assertFalse({"Evolve", "File", "timeline", "Newest", "Brain"} & names)
        self.press("period")
        tick, after = self.wait_for("tick")
        self.press("g")
        self.press("h")
        self.press("period")
        self.wait_for("tick", after=after, number=tick["number"] + 1)
        self.assertNotIn("running", [event["event"] for event in self.events()])
        self.assert_painted(display.picture("viewer-960x640.png"))
        self.quit()
        self.assertEqual(self.files(), ["messages.txt", "status.log"])

    def test_the_viewer_needs_no_write_access(self):
        display = self.open_display(painted=False)
        shutil.copy(ROOT / "assets/creatures/walker.creature.json", self.folder)
        self.forbid_writing()
        before = self.files()
        result = self.as_nobody("view", "walker.creature.json", "--quit-after", 1,
                                env=dict(display.environment, HOME="/nonexistent"))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(self.files(), before)

    def test_a_picture_painted_in_parts_is_as_one_painted_at_once(self):
        display = self.open_display()
        self.start(display)
        self.press("p")
        for name in ("File", "Brain", "Genotype", "timeline"):
            self.click(name)
            display.tool("key", "Escape")
        for _ in range(3):
            self.press("F1")
            self.display.wait_for_frames(4)
        self.press("Escape")
        display.tool("mousemove", 640, 300)
        time.sleep(2.0)
        in_parts = display.picture("painted-in-parts.png")
        display.tool("windowsize", "--sync", self.window, 1200, 760)
        display.tool("windowsize", "--sync", self.window, 1280, 800)
        time.sleep(2.0)
        at_once = display.picture("painted-at-once.png")
        # The colour in the corner differs between frames.
        result = subprocess.run(["compare", "-metric", "AE", "-fuzz", "4%", str(in_parts),
                                 str(at_once), "null:"], check=False, stderr=subprocess.PIPE,
                                encoding="utf-8")
        self.assertEqual(result.stderr.split()[0], "0")
        self.quit()

    def test_a_large_window_is_painted_completely(self):
        display = self.open_display(1920, 1080)
        self.start(display, "--width", 1920, "--height", 1080)
        time.sleep(2.0)
        self.assert_painted(display.picture("studio-1920x1080.png"))
        self.quit()

    def test_the_tour_is_shown_once(self):
        display = self.open_display()
        self.start(display, first_time=True)
        self.wait_for("tour", step=0)
        display.tool("key", "Return")
        _, after = self.wait_for("tour", step=1)
        self.assert_painted(display.picture("tour-1280x800.png"))
        display.tool("key", "Escape")
        self.wait_for("tour", after=after, step=-1)
        self.quit()
        self.start(display, first_time=True)
        self.press("period")
        self.wait_for("tick")
        self.assertNotIn("tour", [event["event"] for event in self.events()])
        self.quit()

    def test_the_keyboard_alone_runs_the_first_minute(self):
        self.write("small.toml", SMALL)
        display = self.open_display()
        self.start(display, "small.toml")
        self.press("g")
        self.wait_for("generation", number=0)
        display.tool("key", "slash")
        self.display.wait_for_frames(4)
        display.tool("type", "--delay", "60", "gravity")
        self.display.wait_for_frames(4)
        self.press("Return")
        self.type_over("1.62")
        self.press("Return")
        _, after = self.wait_for("edited", field="environment.gravity")
        self.assert_painted(display.picture("filter-1280x800.png"))
        display.tool("key", "ctrl+shift+s")
        self.type_over(str(self.folder / "moon"))
        display.tool("key", "Return")
        self.wait_for("saved", after=after)
        self.assertIn("gravity = 1.62", (self.folder / "moon.toml").read_text())
        self.quit()

    def test_a_sample_is_opened_and_stepped_back(self):
        display = self.open_display()
        self.start(display)
        _, after = self.wait_for("shown")
        display.tool("key", "ctrl+shift+o")
        self.wait_for("samples")
        self.display.wait_for_frames(4)
        self.assert_painted(display.picture("samples-1280x800.png"))
        display.tool("key", "Return")
        _, after = self.wait_for("loaded", after=after)
        self.press("period")
        first, after = self.wait_for("tick", after=after)
        for number in [1, 2, 3]:
            self.press("comma")
            back, after = self.wait_for("tick", after=after)
            self.assertEqual(back["number"], first["number"] - number)
        self.quit()

    def test_help_opens_and_closes(self):
        display = self.open_display()
        self.start(display)
        self.click("? viewport")
        self.wait_for("help", page="viewport")
        self.display.wait_for_frames(4)
        self.assert_painted(display.picture("help-1280x800.png"))
        display.tool("key", "Escape")
        self.quit()


if __name__ == "__main__":
    unittest.main(verbosity=2)
