"""The studio and its desktop: scales, clipboard, typefaces, the user's folders."""

import json
import pathlib
import subprocess
import sys
import time
import unittest

from program import CAMBRIAN, DONE, ROOT, SMALL
from studio_driver import StudioTest

CLIENT = pathlib.Path(__file__).with_name("x_client.py")


class StudioDesktop(StudioTest):
    def x_client(self, display, *arguments):
        client = subprocess.Popen([sys.executable, "-B", CLIENT, *arguments],
                                  env=display.environment, stdout=subprocess.PIPE)
        self.addCleanup(client.stdout.close)
        self.addCleanup(self.stop, client)
        self.assertEqual(client.stdout.readline(), b"ready\n")
        return client

    def test_scales_that_no_display_has_open_a_window_that_can_be_used(self):
        display = self.open_display(painted=False)
        for told in ["0", "abc", "", "1", "480000", "96"]:
            client = self.x_client(display, "resources", f"Xft.dpi:\t{told}\n")
            result = subprocess.run(
                [CAMBRIAN, "studio", "--state-dir", "", "--quit-after", "0.5", "--screenshot",
                 "scale.png"], cwd=self.folder, env=display.environment, check=False,
                stderr=subprocess.PIPE, encoding="utf-8", timeout=60)
            self.assertEqual((told, result.stderr, result.returncode), (told, "", DONE))
            client.kill()
            client.wait()

    def seconds_until_it_reacts(self):
        after = len(self.events())
        start = time.monotonic()
        self.display.tool("key", "ctrl+l")
        self.wait_for("theme", after=after)
        return time.monotonic() - start

    def test_a_clipboard_that_never_answers_stops_nothing(self):
        display = self.open_display(painted=False)
        self.start(display)
        self.click("setting filter")
        display.tool("type", "--delay", "60", "grav")
        mute = self.x_client(display, "mute")
        for _ in range(2):
            self.press("ctrl")
            display.act(["keydown", "ctrl", "key", "v"], ["keyup", "ctrl"])
            self.assertLess(self.seconds_until_it_reacts(), 5)
        mute.kill()
        mute.wait()
        # The text of a program that answers is pasted, and so is the studio's own.
        self.x_client(display, "offer", "ity-dir")
        display.act(["keydown", "ctrl", "key", "v"], ["keyup", "ctrl"])
        self.wait_for("place", name="environment.gravity-direction")
        self.wait_for("gone", name="environment.gravity")
        after = len(self.events())
        for key in ["a", "x"]:
            display.act(["keydown", "ctrl", "keydown", key], ["keyup", key, "keyup", "ctrl"])
        _, after = self.wait_for("place", after=after, name="goal.behavior")
        display.act(["keydown", "ctrl", "key", "v"], ["keyup", "ctrl"])
        self.wait_for("gone", after=after, name="goal.behavior")
        self.quit()

    def test_a_name_in_another_script_is_shown_on_one_line(self):
        creature = json.loads((ROOT / "assets/creatures/walker.creature.json").read_text())
        pictures = {}
        for name in ["Жук\nქვა", "????????"]:
            creature["name"] = name
            self.write("named.creature.json", json.dumps(creature))
            display = self.open_display()
            self.start(display, "named.creature.json")
            self.wait_for("shown", title=name.replace("\n", " "))
            self.press("p")
            time.sleep(1.5)
            pictures[name] = display.picture("named-1280x800.png").read_bytes()
            self.quit()
        self.assertEqual(len(set(pictures.values())), 2)

    def test_a_picture_of_the_window_goes_into_the_folder_of_pictures(self):
        display = self.open_display(painted=False)
        (self.folder / "Pictures").mkdir()
        display.environment.update(HOME=str(self.folder), XDG_CONFIG_HOME=str(self.folder / "none"))
        self.start(display)
        self.press("F12")
        saved, _ = self.wait_for("saved")
        self.assertEqual(saved["path"], str(self.folder / "Pictures" / "cambrian-1.png"))
        self.quit()

    def test_settings_that_cannot_be_read_are_kept_and_told(self):
        self.write("small.toml", SMALL)
        state = self.folder / "state"
        state.mkdir()
        (state / "view.conf").write_text("tour-taken = yes\n")
        (state / "experiment.toml").write_text("[environment]\ngravity = \"heavy\"\n")
        display = self.open_display(painted=False)
        self.start(display)
        notice, _ = self.wait_for("notice", problem=True)
        kept = state / "experiment-unreadable-1.toml"
        self.assertIn(str(kept), notice["text"])
        self.assertEqual(kept.read_text(), "[environment]\ngravity = \"heavy\"\n")
        self.quit()


if __name__ == "__main__":
    unittest.main(verbosity=2)
