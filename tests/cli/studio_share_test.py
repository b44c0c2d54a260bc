"""What the studio's window offers to show and to share: clips, the last seconds, pictures for other
programs, the full screen and the presentation."""

import json
import pathlib
import subprocess
import sys
import unittest

from program import ROOT
from studio_driver import StudioTest

CLIENT = pathlib.Path(__file__).with_name("x_client.py")
WALKER = ROOT / "assets/creatures/walker.creature.json"


class StudioShare(StudioTest):
    def clip_facts(self, path):
        form = ["-f", "apng"] if path.suffix == ".png" else []
        told = subprocess.run(
            ["ffprobe", *form, "-v", "error", "-count_frames", "-select_streams", "v:0",
             "-show_entries", "stream=width,height,nb_read_frames", "-of", "json", str(path)],
            check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
        facts = json.loads(told)["streams"][0]
        return facts["width"], facts["height"], int(facts["nb_read_frames"])

    def start_with_walker(self, *arguments):
        display = self.open_display()
        self.start(display, WALKER, *arguments)
        self.wait_for("shown")
        return display

    def test_a_clip_saved_from_the_window_is_that_of_the_command_line(self):
        display = self.start_with_walker()
        display.tool("key", "ctrl+s")
        self.click("Clip")
        self.click("3 s")
        self.assert_painted(display.picture("clip-dialog-dark.png"))
        self.type_over(str(self.folder / "window"))
        display.tool("key", "Return")
        saved, after = self.wait_for("saved")
        self.assertEqual(saved["path"], str(self.folder / "window.gif"))
        self.run_well("render", WALKER, "-o", "command.gif", "--seconds", 3)
        self.assertEqual((self.folder / "window.gif").read_bytes(),
                         (self.folder / "command.gif").read_bytes())
        self.press("ctrl+l")
        display.tool("key", "ctrl+shift+r")
        self.click("Moving card")
        self.assert_painted(display.picture("clip-dialog-light.png"))
        self.type_over(str(self.folder / "walker.card.png"))
        display.tool("key", "Return")
        _, after = self.wait_for("saved", after=after)
        display.tool("key", "ctrl+s")
        self.click("Page")
        self.type_over(str(self.folder / "walker.html"))
        display.tool("key", "Return")
        self.wait_for("saved", after=after)
        self.quit()
        self.assertEqual(self.clip_facts(self.folder / "walker.card.png"), (600, 800, 60))
        self.run_well("page", WALKER, "-o", "command.html")
        self.assertEqual((self.folder / "walker.html").read_bytes(),
                         (self.folder / "command.html").read_bytes())
        for file in ("walker.card.png", "walker.html"):
            self.assertIn("replay verified", self.run_well("verify", file).stdout)

    def test_a_clip_can_be_stopped_and_leaves_nothing(self):
        display = self.start_with_walker()
        display.tool("key", "ctrl+shift+r")
        for choice in ("The whole trial", "¼ ×", "1080p"):
            self.click(choice)
        self.type_over(str(self.folder / "long.gif"))
        display.tool("key", "Return")
        self.click("Stop")
        self.wait_for("stopped")
        self.assertFalse([path for path in self.folder.iterdir() if ".gif" in path.name
                          or path.name.startswith(".cambrian-")])
        self.quit()

    def test_one_key_saves_what_was_seen_lately(self):
        (self.folder / "Pictures").mkdir()
        display = self.open_display()
        display.environment["HOME"] = str(self.folder)
        display.environment["XDG_CONFIG_HOME"] = str(self.folder / "none")
        self.start(display, WALKER)
        self.wait_for("shown")
        display.wait_for_frames(30)
        display.tool("key", "shift+F12")
        saved, _ = self.wait_for("saved")
        path = pathlib.Path(saved["path"])
        self.assertEqual((path.parent.name, path.name), ("Pictures", "cambrian-1.gif"))
        width, height, frames = self.clip_facts(path)
        self.assertLessEqual(width, 640)
        self.assertGreater(height, 100)
        self.assertGreater(frames, 10)
        self.assertLessEqual(frames, 201)
        self.quit()

    def test_another_program_takes_the_picture_of_the_viewport(self):
        display = self.start_with_walker()
        display.tool("key", "ctrl+shift+c")
        self.wait_for("notice", text="The picture is on the clipboard.")
        picture = self.folder / "taken.png"
        for _ in range(20):  # until it is encoded
            subprocess.run([sys.executable, str(CLIENT), "take", str(picture)],
                           env=display.environment, check=True, timeout=60)
            if picture.stat().st_size > 0:
                break
        told = subprocess.run(["convert", str(picture), "-format", "%w %h %k", "info:"],
                              check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
        width, height, colors = map(int, told.split())
        place = [event for event in self.events()
                 if event["event"] == "place" and event["name"] == "viewport"][-1]
        self.assertEqual((width, height), (int(place["width"]), int(place["height"])))
        self.assertGreater(colors, 100)
        self.quit()

    def size_of_window(self):
        lines = self.display.tool("getwindowgeometry", "--shell", self.window).split()
        told = dict(line.split("=") for line in lines)
        return int(told["WIDTH"]), int(told["HEIGHT"])

    def test_the_window_fills_the_screen_and_presents_the_best(self):
        display = self.open_display(1400, 900)
        self.start(display, WALKER, "--width", "1000", "--height", "700")
        self.wait_for("shown")
        before = self.size_of_window()
        self.assertEqual(before, (1000, 700))
        self.press("F11")
        display.wait_for_frames(4)
        self.assertEqual(self.size_of_window(), (1400, 900))
        self.press("F11")
        display.wait_for_frames(4)
        self.assertEqual(self.size_of_window(), before)
        after = len(self.events())
        display.tool("key", "shift+F11")
        first, after = self.wait_for("shown", after=after)
        self.assertEqual(self.size_of_window(), (1400, 900))
        self.assert_painted(display.picture("presentation-1400x900.png"))
        second, after = self.wait_for("shown", after=after)
        self.assertNotEqual(first["name"], second["name"])
        self.press("x")
        last, _ = self.wait_for("shown", after=after)
        self.assertEqual(last["name"], "Walker")
        display.wait_for_frames(4)
        self.assertEqual(self.size_of_window(), before)
        self.quit()


if __name__ == "__main__":
    unittest.main(verbosity=2)
