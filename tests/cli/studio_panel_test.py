"""The command palette, the plain panel of settings and the size of the interface, by keyboard."""

import unittest

from studio_driver import StudioTest


class StudioPanel(StudioTest):
    def find(self, words):
        """Types words into the command palette and takes its first line."""
        after = len(self.events())
        self.display.act(["keydown", "ctrl", "key", "p"], ["keyup", "ctrl"])
        self.wait_for("place", after=after, name="palette words")
        self.display.act(["type", "--delay", "60", words], ["key", "Return"])
        self.wait_for("gone", after=after, name="palette words")
        return after

    def test_the_palette_leads_to_a_setting_an_action_and_the_help(self):
        display = self.open_display(painted=False)
        self.start(display)
        after = self.find("grip")
        self.wait_for("place", after=after, name="## lit setting")
        self.type_over("0.3")
        display.tool("key", "Return")
        self.wait_for("edited", after=after, field="environment.friction")
        # A setting that only the panel of all settings has, in a group that was closed.
        after = self.find("tries")
        self.wait_for("place", after=after, name="group trial")
        self.wait_for("place", after=after, name="## lit setting")
        display.tool("key", "Escape")
        after = self.find("light the")
        self.wait_for("theme", after=after, light=True)
        after = self.find("back to the size that")
        self.wait_for("help", after=after, page="window")
        self.wait_for("place", after=after, name="## marked block")
        self.quit()

    def test_the_size_of_the_interface_is_kept_for_the_next_time(self):
        display = self.open_display(painted=False)
        self.start(display)
        self.wait_for("place", name="panel bar", height=54)
        after = len(self.events())
        for _ in range(2):
            display.act(["keydown", "ctrl", "key", "plus"], ["keyup", "ctrl"])
        self.wait_for("place", after=after, name="panel bar", height=68)
        self.click("All settings")
        self.wait_for("place", after=after, name="group goal")
        self.quit()

        self.start(display)
        self.wait_for("place", name="panel bar", height=68)
        self.wait_for("place", name="group goal")
        after = len(self.events())
        display.act(["keydown", "ctrl", "key", "0"], ["keyup", "ctrl"])
        self.wait_for("place", after=after, name="panel bar", height=54)
        self.quit()

    def test_arrows_choose_from_an_open_list(self):
        display = self.open_display(painted=False)
        self.start(display)
        self.click("goal.behavior")
        self.wait_for("place", name="goal.behavior=walking")
        after = 0
        for _ in range(2):
            display.act(["key", "Down"])
            _, after = self.wait_for("place", after=after, name="## keyboard focus")
        display.act(["key", "Return"])
        self.wait_for("edited", field="goal.behavior")
        self.quit()


if __name__ == "__main__":
    unittest.main(verbosity=2)
