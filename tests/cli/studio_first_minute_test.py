"""What a newcomer sees first, in a real X window: the founders, the tour, the rival, the start
page."""

import unittest

from program import SMALL
from studio_driver import StudioTest


class StudioFirstMinute(StudioTest):
    def test_a_newcomer_is_led_from_the_founders_to_a_saved_creature(self):
        state = self.folder / "state"
        state.mkdir()
        (state / "experiment.toml").write_text(SMALL)
        display = self.open_display()
        self.start(display, first_time=True)
        founders, after = self.wait_for("founders")
        self.assertEqual(founders["count"], 12)
        self.wait_for("tour", step=0)
        self.assert_painted(display.picture("founders-1280x800.png"))
        self.press("g")
        self.wait_for("generation", number=0)
        self.wait_for("shown", title="Champion of generation 0")
        self.wait_for("tour", step=2)
        self.type_into("environment.gravity", "5")
        self.wait_for("tour", step=3)
        self.press("l")
        self.wait_for("tour", step=4)
        self.save_as("ctrl+s", "kept")
        self.wait_for("tour", step=-1)
        self.quit()
        self.run_well("verify", "kept.creature.json")

    def test_a_click_chooses_a_founder_and_a_button_draws_others(self):
        self.write("small.toml", SMALL)
        display = self.open_display()
        self.start(display, "small.toml")
        first, _ = self.wait_for("shown")
        _, after = self.wait_for("founders")
        self.click("Other creatures")
        others, after = self.wait_for("shown", after=after)
        self.assertNotEqual(first["uid"], others["uid"])
        self.wait_for("founders", after=after)
        self.click("founders")  # somewhere in the middle, where there are several
        chosen, _ = self.wait_for("shown", after=after)
        self.assertNotEqual(chosen["uid"], others["uid"])
        self.quit()

    def test_the_start_page_opens_saved_runs_and_forgets_missing_ones(self):
        self.write("small.toml", SMALL)
        display = self.open_display()
        self.start(display, "small.toml")
        self.press("g")
        self.wait_for("generation", number=0)
        self.wait_for("paused")
        for name in ("first", "second"):
            self.save_as("ctrl+k", name)
        self.quit()

        self.start(display)
        page, after = self.wait_for("start page")
        self.assertEqual(page["runs"], 2)
        self.assert_painted(display.picture("start-page-1280x800.png"))
        self.click("run first")
        opened, _ = self.wait_for("experiment", path=str(self.folder / "first.cambrian"))
        self.assertEqual(opened["generations"], 1)
        self.quit()

        (self.folder / "second.cambrian").unlink()
        self.start(display)
        self.wait_for("start page")
        self.click("forget second")
        self.wait_for("gone", name="forget second")
        self.click("Go on with the last run")
        self.wait_for("gone", name="panel start")
        self.quit()
        kept = (self.folder / "state" / "recent.txt").read_text()
        self.assertEqual(kept.splitlines(), [str(self.folder / "first.cambrian")])


if __name__ == "__main__":
    unittest.main()
