"""Creatures in three dimensions in a real X window: they evolve, are picked and pulled, saved and
opened again, and the window goes from one world to the other."""

import json
import subprocess
import unittest

from program import ROOT, SMALL
from studio_driver import StudioTest

SMALL_3D = """[goal]
behavior = "swimming"
[environment]
dimensions = 3
[population]
size = 8
[trial]
duration = 2
"""


class StudioSpace(StudioTest):
    def evolve_one_generation(self, display, *options):
        self.write("swim.toml", SMALL_3D)
        self.start(display, "swim.toml", *options)
        self.wait_for("founders", count=8)
        self.assert_painted(display.picture("space-founders-1280x800.png"))
        self.press("g")
        self.wait_for("generation", number=0)
        self.wait_for("shown", title="Champion of generation 0")

    def test_a_person_evolves_swimmers_in_space_saves_one_and_comes_back(self):
        display = self.open_display()
        self.evolve_one_generation(display)
        self.wait_for("place", name="axes")
        self.assert_painted(display.picture("space-1280x800.png"))
        self.save_as("ctrl+s", "swimmer")
        self.quit()
        saved = json.loads((self.folder / "swimmer.creature.json").read_text())
        self.assertEqual(saved["dimensions"], 3)
        self.run_well("verify", "swimmer.creature.json")

        self.start(display, "swimmer.creature.json")
        loaded, _ = self.wait_for("loaded")
        self.assertIn("swimmer.creature.json", loaded["path"])
        self.wait_for("place", name="axes")
        self.quit()

        # The experiment that was left is in space, so the window opens there.
        self.start(display)
        self.wait_for("experiment", generations=1)
        self.quit()

        self.open_window(display, "view", "swimmer.creature.json")
        self.wait_for("place", name="axes")
        self.quit()

    def seen(self, display):
        """Returns the pixels in the middle of the viewport."""
        place = self.wait_for("place", name="viewport")[0]
        width, height = int(place["width"] / 2), int(place["height"] / 2)
        crop = f"{width}x{height}+{int(place['x']) + width // 2}+{int(place['y']) + height // 2}"
        return subprocess.run(["convert", str(display.picture("space-view.png")), "-crop", crop,
                               "rgb:-"], check=True, stdout=subprocess.PIPE).stdout

    def test_keys_and_mouse_turn_the_view_and_pull_parts(self):
        display = self.open_display()
        self.evolve_one_generation(display, "--scenery", "light")
        self.press("p")  # so that it stays where it is
        x, y = self.place_of("viewport")
        display.act(["mousemove", 5, 5])
        self.press("Home")
        display.wait_for_frames(8)
        slanted = self.seen(display)
        self.assertEqual(self.seen(display), slanted)
        for key in ["KP_1", "KP_3", "KP_7"]:
            self.press(key)
            self.assertNotEqual(self.seen(display), slanted, key)
        self.press("KP_5")
        self.assertEqual(self.seen(display), slanted)
        display.act(["mousemove", x, y], ["mousedown", 1], ["mousemove", x + 60, y + 30])
        self.assertNotEqual(self.seen(display), slanted)  # the hand and the body it holds
        display.act(["mouseup", 1], ["mousemove", 5, 5])
        axes_x, axes_y = self.place_of("axes")
        display.act(["mousemove", axes_x, axes_y], ["mousedown", 1],
                    ["mousemove", axes_x + 40, axes_y + 10], ["mouseup", 1], ["mousemove", 5, 5])
        turned = self.seen(display)
        self.assertNotEqual(turned, slanted)
        display.act(["mousemove", x, y + 150], ["mousedown", 3], ["mousemove", x + 80, y + 150],
                    ["mouseup", 3], ["mousemove", 5, 5])
        self.assertNotEqual(self.seen(display), turned)
        self.quit()

    def test_the_window_goes_from_one_world_to_the_other_and_keeps_both_runs(self):
        self.write("swim.toml", SMALL_3D)
        self.write("small.toml", SMALL)
        display = self.open_display(painted=False)
        self.start(display, "small.toml")
        self.press("g")
        _, after = self.wait_for("generation", number=0)
        self.click("Three")
        _, after = self.wait_for("crossing", after=after)
        self.wait_for("started", after=after)
        self.wait_for("founders", after=after)  # before or after the first frame
        self.press("g")
        self.wait_for("generation", after=after, number=0)
        display.tool("key", "ctrl+n")
        notice, _ = self.wait_for("notice", problem=True)
        self.assertIn("Preserves are flat", notice["text"])
        after = len(self.events())
        display.tool("key", "ctrl+o")
        self.type_over(str(ROOT / "assets/creatures/dart.creature.json"))
        display.tool("key", "Return")
        self.wait_for("crossing", after=after)
        loaded, _ = self.wait_for("loaded", after=after)
        self.assertIn("dart", loaded["path"])
        self.quit()

    def test_swimmers_in_space_are_picked_by_hand(self):
        self.write("swim.toml", SMALL_3D)
        display = self.open_display()
        self.start(display, "swim.toml")
        self.press("h")
        self.wait_for("place", name="cell 4")
        self.assert_painted(display.picture("space-grid-1280x800.png"))
        self.press("1")
        self.quit()


if __name__ == "__main__":
    unittest.main(verbosity=2)
