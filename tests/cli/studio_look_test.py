"""How the studio looks: every panel and mode at several sizes, on the dark and the light theme.

What a program can tell is asserted at each look: controls stand completely in their window and do not
lie over each other, and no text is cut or written over other text. Pictures are for the eye; they are kept
where CAMBRIAN_KEEP_LOOKS is set.
"""

import os
import time
import unittest

from studio_driver import PATIENCE, StudioTest

# A small run with something to show in every part of the window.
RUN = """
[population]
size = 24
[trial]
duration = 2
"""
CLOSED_AT_FIRST = ["breeding", "mutation.weights", "body", "body.joints", "body.functions",
                   "body.sensors", "body.organs", "body.references", "simulation", "trial", "run"]
INSPECTOR_TABS = ["Creature", "Brain", "Genotype", "Ancestry", "Energy", "Lesions"]
PLOTS = ["fitness", "diversity", "kinds", "lines", "parts", "neurons", "trials", "invalid"]
TOUR_STEPS = 5
KEEPS_PICTURES = "CAMBRIAN_KEEP_LOOKS" in os.environ
MOST_PAGES = 24  # pages of the experiment panel
# Panels, backgrounds of controls, and parts of a row that has its own name.
NOT_CONTROLS = ("panel ", "viewport", "world", "tile ", "cell ", "shelf", "##")


def corners(place):
    return [place[name] for name in ["x", "y", "width", "height"]]


def overlap(a, b):
    """Returns whether two rectangles overlap by more than a pixel in both directions."""
    return (min(a["x"] + a["width"], b["x"] + b["width"]) - max(a["x"], b["x"]) > 1 and
            min(a["y"] + a["height"], b["y"] + b["height"]) - max(a["y"], b["y"]) > 1)


def place_faults(places):
    places = [place for name, place in sorted(places.items()) if not name.startswith(NOT_CONTROLS)]
    faults = [f"{place['name']} is cut" for place in places if place["cut"]]
    for index, place in enumerate(places):
        faults += [f"{place['name']} and {other['name']} overlap" for other in places[:index]
                   if place["panel"] == other["panel"] and overlap(place, other)]
    return faults


class StudioLook(StudioTest):
    frame_rate = 20

    def test_everything_looks_right_at_1280x720(self):
        self.look_at_everything(1280, 720, 1, painted=True)

    def test_everything_looks_right_at_1920x1080(self):
        self.look_at_everything(1920, 1080, 1)

    def test_everything_looks_right_at_1920x1080_twice_as_large(self):
        self.look_at_everything(1920, 1080, 2)

    def test_everything_looks_right_at_2560x1440_twice_as_large(self):
        self.look_at_everything(2560, 1440, 2, [self.look_at_window, self.look_at_menus,
                                                self.look_at_cards, self.look_at_inspector,
                                                self.look_at_hand_picking, self.look_at_preserve])

    def test_everything_can_be_reached_at_1280x800_twice_as_large(self):
        self.look_at_everything(1280, 800, 2, [self.look_at_window, self.look_at_menus,
                                               self.look_at_cards, self.look_at_timeline])

    def look_at_everything(self, width, height, scale, looks=None, painted=False):
        """Pixels are painted at one size, and wherever pictures are kept."""
        self.size = f"{width}x{height}" + ("" if scale == 1 else f"@{scale}x")
        self.corner = (width - 2, 2)
        self.light = False
        self.read = 0
        self.places = {}
        self.faults = []
        self.write("run.toml", RUN)
        self.write("cut.creature.json", '{"format": "cambrian-creature", "ver')
        display = self.open_display(width, height, painted or KEEPS_PICTURES)
        self.start(display, "run.toml", "--width", width, "--height", height, "--scale", scale)
        for number in range(3):
            self.press("g")
            self.wait_for("generation", number=number)
        for look in looks or [
                self.look_at_window, self.look_at_menus, self.look_at_experiment,
                self.look_at_cards, self.look_at_inspector, self.look_at_timeline,
                self.look_at_population, self.look_at_tour, self.look_at_overlays,
                self.look_at_hand_picking, self.look_at_preserve]:
            look()
        self.quit()
        self.assertEqual(self.faults, [], "\n".join(self.faults))

    def look_at_window(self):
        self.look("window")
        self.keys("ctrl+o")
        self.type(str(self.folder / "cut.creature.json"))
        self.keys("Return")
        self.wait_for("notice", problem=True)
        self.look("error")
        self.keys("Escape")

    def look_at_menus(self):
        self.tap("File")
        for menu in ["File", "Edit", "View", "Help"]:
            self.point_at(menu)
            self.look("menu-" + menu.lower(), pointed=True)
        self.tap_nowhere()
        self.tap("Export")
        self.look("menu-export")
        self.tap_nowhere()

    def look_at_experiment(self):
        self.keys("slash")
        self.type("grav")
        self.look("experiment-filter")
        self.keys("Escape")
        self.tap("goal.behavior")
        self.look("experiment-goals")
        self.tap_nowhere()
        before = corners(self.seen()["panel timeline"])
        self.switch_bottom()
        self.wait_until(lambda: "panel timeline" not in self.seen(), "the timeline stays")
        self.look_through_settings()
        self.switch_bottom()
        self.wait_until(lambda: "panel timeline" in self.seen(), "the timeline stays away")
        self.assertEqual(corners(self.seen()["panel timeline"]), before)

    def switch_bottom(self):
        self.tap("View")
        self.tap("Timeline and population")

    def look_through_settings(self):
        """Scrolls down the panel and opens closed groups."""
        self.tap("All settings")
        self.point_at("group goal")
        closed = list(CLOSED_AT_FIRST)
        page = 0
        while closed:
            while closed and "group " + closed[0] in self.seen():
                self.tap("group " + closed.pop(0))
            self.look(f"experiment-{page}", pointed=True)
            page += 1
            self.display.act(["click", "--repeat", 4, "--delay", 30, 5])
            self.assertLess(page, MOST_PAGES, f"{closed} are not in sight")
        self.display.act(["click", "--repeat", 20, "--delay", 30, 5])
        self.look(f"experiment-{page}", pointed=True)

    def look_at_cards(self):
        self.keys("ctrl+p")
        self.type("grav")
        self.look("palette")
        self.keys("Escape")
        for name, keys, control in [("open", "ctrl+o", "file name"),
                                    ("save", "ctrl+s", "file name"),
                                    ("samples", "ctrl+shift+o", "Close samples"),
                                    ("help", "F1", "Close help")]:
            self.keys(keys)
            self.wait_until(lambda: control in self.seen(), f"{name} does not open")
            self.look(name)
            self.keys("Escape")
            self.wait_until(lambda: control not in self.seen(), f"{name} does not close")
        for name, entry in [("keys", "Keys"), ("about", "About Cambrian")]:
            self.tap("Help")
            self.tap(entry)
            self.wait_until(lambda: "Close help" in self.seen(), f"{name} does not open")
            self.look(name)
            self.keys("Escape")
            self.wait_until(lambda: "Close help" not in self.seen(), f"{name} does not close")

    def look_at_inspector(self):
        for tab in INSPECTOR_TABS:
            self.tap(tab)
            self.look("inspector-" + tab.lower())
        self.tap("Genotype")
        self.tap("gene 0")
        self.look("inspector-gene")

    def look_at_timeline(self):
        self.keys("t")
        for plot in PLOTS:
            self.look("timeline-" + plot)
            self.keys("Down")
        self.keys("Left")
        self.point_at("timeline")
        time.sleep(0.6)
        self.look("timeline-pointed-at", pointed=True)

    def look_at_population(self):
        self.keys("c", "Right", "k")
        self.look("population-starred")
        self.tap("tile order")
        self.look("population-orders")
        self.tap_nowhere()
        self.tap("One per body plan")
        self.look("population-one-a-plan")
        self.tap("One per body plan")

    def look_at_tour(self):
        self.tap("Help")
        self.tap("Tour of the window")
        for step in range(TOUR_STEPS):
            self.look(f"tour-{step}")
            self.keys("Return")

    def look_at_overlays(self):
        self.tap("Overlays")
        for overlay in ["Contact forces", "Joint torques", "Joint limits", "Sensors", "Part names"]:
            if overlay in self.seen():
                self.tap(overlay)
        self.look("overlays-menu")
        self.tap_nowhere()
        self.tap("Ghosts")
        self.look("ghosts-menu")
        self.tap("Five across the run")
        self.tap_nowhere()
        self.look("overlays")

    def look_at_hand_picking(self):
        self.keys("h")
        self.wait_for("grid", number=0)
        self.keys("1", "3", "8")
        self.look("hand-picking")
        self.keys("Return")
        self.wait_for("grid", number=1)
        self.keys("2", "k", "BackSpace", "5", "Return")
        self.wait_for("grid", number=2)
        self.keys("3", "k")
        self.look("hand-picking-branched")
        self.keys("v")
        self.look("hand-picking-viewed")
        self.keys("Escape", "h")

    def look_at_preserve(self):
        self.keys("ctrl+n")
        self.look("preserve-card")
        self.keys("Return")
        _, after = self.wait_for("preserve", on=True)
        self.look("preserve")
        self.keys("Tab", "p", "space")
        self.wait_for("world", after=after, playing=False)
        self.look("preserve-picked")
        self.keys("n", "r")
        self.look("preserve-laws")
        self.keys("g")
        self.look("preserve-museum")
        self.tap("go back")
        self.look("preserve-snapshots", pointed=True)
        self.tap_nowhere()
        self.keys("Home", "Tab", "v")
        self.look("preserve-alone")
        self.keys("Escape", "ctrl+w")
        self.wait_for("preserve", on=False)

    def keys(self, *names):
        for name in names:
            keys = name.split("+")
            self.display.act([word for key in keys for word in ["keydown", key]],
                             [word for key in reversed(keys) for word in ["keyup", key]])

    def type(self, text):
        self.type_over(text)

    def point_at(self, name):
        self.wait_until(lambda: name in self.seen(), f"no '{name}' in sight")
        place = None
        while place != self.seen().get(name, place):  # menus take a few frames to find their place
            place = self.places[name]
            self.display.wait_for_frames()
        self.display.act(["mousemove", int(place["x"] + place["width"] / 2),
                          int(place["y"] + place["height"] / 2)])

    def tap(self, name):
        self.point_at(name)
        self.display.act(["mousedown", 1], ["mouseup", 1])

    def tap_nowhere(self):
        self.display.act(["mousemove", *self.corner], ["mousedown", 1], ["mouseup", 1])
        self.wait_until(lambda: not any(place["panel"].startswith("##")
                                        for place in self.seen().values()), "the menu stays")

    def wait_until(self, done, complaint):
        end = time.monotonic() + PATIENCE
        while not done():
            self.assertLess(time.monotonic(), end, complaint)
            time.sleep(0.05)

    def seen(self):
        """Returns the places of all visible controls."""
        events = self.events()
        for event in events[self.read:]:
            if event["event"] == "place":
                self.places[event["name"]] = event
            elif event["event"] == "gone":
                self.places.pop(event["name"], None)
            elif event["event"] == "text fault":
                self.faults.append(f"{self.size}: {event}")
        self.read = len(events)
        return self.places

    def look(self, name, pointed=False):
        """Checks the window in the other theme. The pointer is moved away unless it points at
        something. Saves one picture per theme if pictures are kept."""
        if not pointed:
            self.display.tool("mousemove", *self.corner)
        self.display.wait_for_frames()  # for effects that follow the pointer
        for _ in range(2 if KEEPS_PICTURES else 1):
            self.light = not self.light
            # Keys are handled in order, so everything requested before this key has been drawn,
            # too.
            after = len(self.events())
            self.keys("ctrl+l")
            self.wait_for("theme", after=after, light=self.light)
            if KEEPS_PICTURES:
                theme = "light" if self.light else "dark"
                self.display.picture(f"{self.size}-{theme}-{name}.png")
        self.faults += [f"{self.size} {name}: {fault}" for fault in place_faults(self.seen())]


if __name__ == "__main__":
    unittest.main(verbosity=2)
