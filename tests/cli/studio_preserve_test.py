"""The studio's preserve in a real X window: its first minute, with the mouse and with keys alone."""

import pathlib
import unittest

from experiment_tables import opened
from program import FERTILE, ROOT
from studio_driver import StudioTest

SWIMMER = ROOT / "assets" / "creatures" / "squid.creature.json"


class StudioPreserve(StudioTest):
    def begin(self, display):
        """Begins a preserve with the samples that swim; returns the position after it in the log."""
        self.start(display)
        display.tool("key", "ctrl+n")
        self.wait_for("place", name="Begin")
        self.display.wait_for_frames(4)
        self.press("Return")
        begun, after = self.wait_for("preserve", on=True)
        self.assertEqual(begun["creatures"], 40)
        return after

    def state(self, after, **wanted):
        return self.wait_for("world", after=after, **wanted)

    def test_the_first_minute_of_a_preserve(self):
        display = self.open_display()
        after = self.begin(display)
        first, after = self.state(after, playing=True)
        later, after = self.state(after, playing=True)
        self.assertGreater(later["tick"], first["tick"])

        self.press("Tab")
        _, after = self.wait_for("picked", after=after, number=1)
        self.wait_for("place", name="live brain")
        first, after = self.state(after, picked=1)
        later, after = self.state(after, picked=1)
        self.assertNotEqual((first["x"], first["y"]), (later["x"], later["y"]))
        self.press("r")
        self.wait_for("energy rings", after=after, on=True)
        self.click("Follow")
        _, after = self.wait_for("follow", after=after, on=True)
        self.assert_painted(display.picture("preserve-1280x800.png"))

        self.press("space")
        paused, after = self.state(after, playing=False)
        self.press("e")
        fed, after = self.wait_for("intervention", after=after, what="feed", done=True)
        self.assertEqual(fed["number"], 10)
        display.tool("key", "ctrl+o")
        self.wait_for("place", name="file name", after=after)
        self.type_over(str(SWIMMER))
        display.tool("key", "Return")
        added, after = self.wait_for("intervention", after=after, what="add", done=True)
        self.assertGreater(added["number"], 40)

        saved = self.save_as("s", "found")
        self.assertEqual(saved.name, "found.creature.json")
        self.run_well("simulate", saved)
        self.press("Delete")
        _, after = self.wait_for("intervention", after=after, what="remove", done=True)
        self.wait_for("died", after=after - 2, cause="removed")
        self.quit()

        kept = self.folder / "state" / "preserve.cambrian"
        self.run_well("verify", kept)
        self.start(display, kept)
        opened, _ = self.wait_for("preserve", on=True)
        self.assertGreaterEqual(opened["tick"], paused["tick"])
        self.quit()

    def test_a_preserve_whose_edges_meet_is_begun_with_keys_and_looked_at(self):
        display = self.open_display()
        self.start(display)
        display.tool("key", "ctrl+n")
        _, after = self.wait_for("place", name="Edges that meet")
        self.display.wait_for_frames(4)
        self.press("Right")
        self.display.wait_for_frames(4)
        self.assert_painted(display.picture("preserve-edges-card-1280x800.png"))
        self.press("Return")
        _, after = self.wait_for("preserve", on=True)
        self.press("Tab")
        _, after = self.wait_for("picked", after=after, number=1)
        self.press("f")
        _, after = self.wait_for("follow", after=after, on=True)
        _, after = self.state(after, picked=1)
        self.display.wait_for_frames(4)
        self.assert_painted(display.picture("preserve-edges-1280x800.png"))
        self.quit()
        kept = self.folder / "state" / "preserve.cambrian"
        with opened(kept) as file:
            settings, = file.execute("SELECT value FROM facts WHERE name = 'settings'").fetchone()
        self.assertIn('edges = "wrap"', settings)
        self.run_well("verify", kept)

    def test_a_wall_is_drawn_and_erased_with_the_mouse_and_with_keys(self):
        display = self.open_display()
        after = self.begin(display)
        self.press("space")
        _, after = self.state(after, playing=False)
        self.click("Draw a wall")
        self.drag("world", 0.2, 0.4)
        built, after = self.wait_for("intervention", after=after, what="wall", done=True)
        self.assertEqual(built["number"], 1)
        x, y = self.place_of("world")
        display.act(["mousemove", x + 20, y - 100])
        self.press("w")
        display.act(["mousemove", x + 160, y + 90])
        self.assert_painted(display.picture("preserve-wall-1280x800.png"))
        self.press("w")
        built, after = self.wait_for("intervention", after=after, what="wall", done=True)
        self.assertEqual(built["number"], 2)
        self.state(after - 1, walls=2)
        self.press("x")
        left, after = self.wait_for("intervention", after=after, what="erase", done=True)
        self.assertEqual(left["number"], 1)
        for plot in (1, 2):
            self.press("t")
            turned, after = self.wait_for("world plot", after=after)
            self.assertEqual(turned["index"], plot)
        self.press("l")
        self.wait_for("picked", after=after)
        self.quit()
        self.run_well("verify", self.folder / "state" / "preserve.cambrian")

    def test_laws_are_typed_dragged_and_kept(self):
        display = self.open_display()
        after = self.begin(display)
        self.press("space")
        _, after = self.state(after, playing=False)
        self.press("n")
        _, after = self.wait_for("world list", after=after, name="Laws")
        self.wait_for("place", name="preserve.growth-time")
        self.assert_painted(display.picture("preserve-laws-1280x800.png"))
        self.press("j")
        self.type_over("30")
        self.press("Tab")
        _, after = self.wait_for("intervention", after=after, what="law preserve.growth-time",
                                 done=True)
        self.type_over("4")
        self.press("Return")
        _, after = self.wait_for("intervention", after=after, what="law preserve.plant-energy",
                                 done=True)
        self.drag("preserve.body-upkeep", 0.2, 0.7)
        _, after = self.wait_for("intervention", after=after, what="law preserve.body-upkeep",
                                 done=True)
        self.quit()
        kept = self.folder / "state" / "preserve.cambrian"
        self.run_well("verify", kept)
        with opened(kept) as file:
            laws = dict(file.execute("SELECT what, x FROM interventions WHERE what LIKE 'law %'"))
        self.assertEqual((laws["law preserve.growth-time"], laws["law preserve.plant-energy"]),
                         (30, 4))
        self.run_well("preserve", "--resume", kept, "--seconds", 30)
        self.run_well("verify", kept)

    def test_pins_are_inherited_and_kept(self):
        display = self.open_display(painted=False)
        after = self.begin(display)
        self.press("space")
        _, after = self.state(after, playing=False)
        for pinned in (1, 2):
            self.press("Tab")
            _, after = self.wait_for("picked", after=after, number=pinned)
            self.press("p")
            _, after = self.wait_for("pins", after=after, creatures=pinned, inherited=False)
        display.tool("key", "shift+p")
        _, after = self.wait_for("pins", after=after, creatures=2, inherited=True)
        self.click("Pin children")
        self.wait_for("pins", after=after, creatures=2, inherited=False)
        self.quit()
        self.start(display, self.folder / "state" / "preserve.cambrian")
        _, after = self.wait_for("preserve", on=True)
        self.press("Tab")
        _, after = self.wait_for("picked", after=after, number=1)
        self.press("p")
        self.wait_for("pins", after=after, creatures=1)
        self.quit()

    def test_the_museum_is_seen_and_its_creatures_are_saved(self):
        self.write("rich.toml", FERTILE)
        self.run_well("preserve", "rich.toml", "-f", SWIMMER, "--seconds", 60, "-o", "rich.cambrian")
        names = self.run_well("export", "rich.cambrian", "--museum", "-o", "museum").stdout.split()
        display = self.open_display()
        self.start(display, self.folder / "rich.cambrian")
        _, after = self.wait_for("preserve", on=True)
        self.press("g")
        _, after = self.wait_for("world list", after=after, name="Museum")
        self.press("g")
        chosen, after = self.wait_for("museum piece", after=after)
        self.assertIn(f"creature-{chosen['number']:.0f}-{chosen['reason']}.creature.json", names)
        self.assert_painted(display.picture("preserve-museum-1280x800.png"))
        saved = self.save_as("shift+s", "piece")
        self.run_well("simulate", saved, "--seconds", 1)
        self.press("Return")
        self.wait_for("place", name="Back to the world", after=after)
        again = self.save_as("ctrl+s", "again")
        self.assertEqual(again.read_bytes(), saved.read_bytes())
        self.quit()

    def press_for(self, key, event, after, **wanted):
        """Presses a key and waits for what it does; returns that and the position after it."""
        self.press(key)
        return self.wait_for(event, after=after, **wanted)

    def test_a_world_is_played_and_changed_by_keys_alone(self):
        display = self.open_display(painted=False)
        after = self.begin(display)
        display.tool("mousemove", 2, 2)
        paused, after = self.press_for("space", "world", after, playing=False)
        for key, pace in (("bracketright", 4), ("bracketleft", 1), ("bracketleft", 0.1)):
            _, after = self.press_for(key, "world", after, pace=pace)
        for tick in (paused["tick"] + 1, paused["tick"] + 2):
            _, after = self.press_for("period", "world", after, tick=tick)
        for key in ("Tab", "l", "o"):
            picked, after = self.press_for(key, "picked", after)
        number = picked["number"]
        _, after = self.press_for("f", "follow", after, on=True)
        _, after = self.press_for("m", "intervention", after, what="move", number=number, done=True)
        self.press("v")
        _, after = self.wait_for("place", name="Back to the world")
        self.press("Escape")
        self.display.wait_for_frames(4)
        _, after = self.press_for("a", "intervention", after, what="add", done=True)
        _, after = self.press_for("e", "intervention", after, what="feed", done=True)
        self.press("Home")
        self.press("w")
        self.press("Right")  # more than once if frames are slow
        _, after = self.press_for("w", "intervention", after, what="wall", done=True)
        _, after = self.press_for("x", "intervention", after, what="erase", done=True)
        _, after = self.press_for("r", "energy rings", after, on=True)
        _, after = self.press_for("t", "world plot", after, index=1)
        for name in ("Laws", "Museum", "Lineages"):
            _, after = self.press_for("n", "world list", after, name=name)
        _, after = self.press_for("Delete", "intervention", after, what="remove", done=True)
        display.tool("key", "ctrl+z")
        branch, after = self.wait_for("preserve", after=after, on=True)
        self.assertEqual(branch["tick"], 0)
        display.tool("key", "ctrl+w")
        self.wait_for("preserve", after=after, on=False)
        self.quit()
        self.run_well("verify", self.folder / "state" / "preserve.cambrian")

    def test_a_preserve_goes_back_to_a_snapshot_and_is_kept_elsewhere(self):
        display = self.open_display(painted=False)
        after = self.begin(display)
        self.press("space")
        _, after = self.state(after, playing=False)
        self.click("go back")
        self.click("back to 0:00")
        branch, after = self.wait_for("preserve", after=after, on=True)
        self.assertEqual(branch["tick"], 0)
        self.assertEqual(pathlib.Path(branch["path"]).name, "preserve-from-0s.cambrian")
        self.press("period")
        _, after = self.state(after, tick=1)
        display.tool("key", "ctrl+k")
        self.wait_for("place", name="file name", after=after)
        self.type_over(str(self.folder / "mine"))
        display.tool("key", "Return")
        moved, after = self.wait_for("preserve", after=after, on=True)
        self.assertEqual((moved["path"], moved["tick"]), (str(self.folder / "mine.cambrian"), 1))
        display.tool("key", "ctrl+w")
        _, after = self.wait_for("preserve", after=after, on=False)
        display.tool("key", "ctrl+o")
        self.type_over("mine.cambrian")
        display.tool("key", "Return")
        opened, _ = self.wait_for("preserve", after=after, on=True)
        self.assertEqual(opened["tick"], 1)
        self.quit()
        for name in ["state/preserve.cambrian", "state/preserve-from-0s.cambrian", "mine.cambrian"]:
            self.run_well("verify", self.folder / name)


if __name__ == "__main__":
    unittest.main()
