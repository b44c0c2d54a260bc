"""Controls the studio in a real X window: sends mouse and keyboard input, and reads its status
log."""

import json
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import time
import unittest
import zlib

from program import CAMBRIAN, DONE, ProgramTest

PICTURES = pathlib.Path(os.environ.get("CAMBRIAN_PICTURES", "pictures"))
PATIENCE = 120  # s to wait for any event on a busy machine


def png_of_dump(dump):
    """Converts an X server's screen dump in the format of xwd, 32 bits per pixel, to a PNG
    picture."""
    header = struct.unpack(">25I", dump[:100])
    size, width, height, bits, stride, colors = (header[i] for i in [0, 4, 5, 11, 12, 19])
    assert bits == 32, f"{bits} bits a pixel"
    start = size + 12 * colors
    pixels = memoryview(dump)[start:start + stride * height]
    rows = bytearray((3 * width + 1) * height)
    for row in range(height):
        line = bytearray(3 * width)
        source = pixels[row * stride:row * stride + 4 * width]
        line[0::3], line[1::3], line[2::3] = source[2::4], source[1::4], source[0::4]
        rows[row * (3 * width + 1) + 1:(row + 1) * (3 * width + 1)] = line

    def chunk(kind, data):
        checked = kind + data
        return struct.pack(">I", len(data)) + checked + struct.pack(">I", zlib.crc32(checked))
    about = struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", about)
            + chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))


class Display:
    """A separate virtual X display, so that tests can run side by side. Keys do not repeat, since
    on a busy machine they would be held for long."""

    def __init__(self, width, height):
        self.memory = tempfile.TemporaryDirectory(prefix="cambrian-screen-")
        reading, writing = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{width}x{height}x24",
             "-r", "-fbdir", self.memory.name, "-nolisten", "tcp"],
            pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as numbers:
            self.name = ":" + numbers.readline().strip()
        self.environment = dict(os.environ, DISPLAY=self.name, LIBGL_ALWAYS_SOFTWARE="1")
        self.frame_log = pathlib.Path(self.memory.name, "frames.csv")  # of the window shown last

    def tool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True,
                              stdout=subprocess.PIPE, encoding="utf-8", timeout=PATIENCE).stdout

    def wait_for_frames(self, count=2):
        """Waits until so many frames of the window have ended. The second began after the call, so
        it shows all that was done before, however long frames take."""
        wanted = self.frames() + count
        end = time.monotonic() + PATIENCE
        while self.frames() < wanted and time.monotonic() < end:
            time.sleep(0.01)

    def frames(self):
        return self.frame_log.read_bytes().count(b"\n") if self.frame_log.exists() else 0

    def act(self, *steps):
        """Sends xdotool's commands one by one, each in a frame of its own."""
        for step in steps:
            self.tool(*step)
            self.wait_for_frames()

    def picture(self, name):
        PICTURES.mkdir(parents=True, exist_ok=True)
        path = PICTURES / name
        self.wait_for_frames()
        screen = pathlib.Path(self.memory.name, "Xvfb_screen0").read_bytes()
        # Whole at once, since tests that run beside each other may write the same picture.
        unfinished = path.with_name(f"{os.getpid()}-{name}")
        unfinished.write_bytes(png_of_dump(screen))
        unfinished.replace(path)
        return path

    def close(self):
        self.server.terminate()
        self.server.wait(PATIENCE)
        self.memory.cleanup()


@unittest.skipUnless(shutil.which("Xvfb") and shutil.which("xdotool"), "needs Xvfb and xdotool")
class StudioTest(ProgramTest):
    # Hz; a window without a graphics card spends most of its time on frames. Keys that are pressed
    # and released at once need a short frame.
    frame_rate = 12

    def open_display(self, width=1280, height=800, painted=True):
        """Unless painted, the graphics driver omits pixels, which saves a quarter of the time."""
        display = Display(width, height)
        if not painted:
            display.environment["LP_NO_RAST"] = "1"
        self.addCleanup(display.close)
        return display

    def start(self, display, *arguments, first_time=False, priority="normal"):
        """Starts the studio and waits for its first frame. Its tour counts as taken unless this is
        the first time. Its computations have normal priority, so that other tests do not starve
        them while the window draws."""
        view = self.folder / "state" / "view.conf"
        if not first_time and not view.exists():
            view.parent.mkdir(exist_ok=True)
            view.write_text("tour-taken = yes\n")
        self.open_window(display, "studio", "--state-dir", self.folder / "state", "--threads", "1",
                         "--priority", priority, *arguments)

    def open_window(self, display, subcommand, *arguments):
        """Starts a subcommand that opens a window and waits for its first frame."""
        self.log = self.folder / "status.log"
        self.log.unlink(missing_ok=True)
        self.log_read = 0  # bytes of the log read so far
        self.happened = []
        self.display = display
        self.messages = self.folder / "messages.txt"
        with self.messages.open("wb") as messages:
            studio = subprocess.Popen(
                [CAMBRIAN, subcommand, "--status-log", str(self.log), "--frame-log",
                 str(display.frame_log), "--frame-rate", str(self.frame_rate),
                 *map(str, arguments)],
                cwd=self.folder, env=display.environment, stdout=subprocess.DEVNULL,
                stderr=messages)
        self.addCleanup(self.stop, studio)
        self.studio = studio
        self.wait_for("started")
        self.window = display.tool("search", "--sync", "--name", "Cambrian").split()[0]
        display.tool("windowfocus", self.window)

    def stop(self, studio):
        if studio.poll() is None:
            studio.kill()
        studio.wait(PATIENCE)

    def schedulers(self):
        """Returns the scheduling policies of the studio's threads."""
        return {os.sched_getscheduler(int(thread.name))
                for thread in pathlib.Path(f"/proc/{self.studio.pid}/task").iterdir()}

    def events(self):
        if self.log.exists():
            with self.log.open("rb") as file:
                file.seek(self.log_read)
                whole_lines, newline, _ = file.read().rpartition(b"\n")
            self.log_read += len(whole_lines + newline)
            self.happened += [json.loads(line) for line in whole_lines.splitlines()]
        return self.happened

    def wait_for(self, event, after=0, **fields):
        """Returns the first such event at or after a position in the log, and the position after
        it."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            for place, found in enumerate(self.events()):
                if place >= after and found["event"] == event and fields.items() <= found.items():
                    return found, place + 1
            if self.studio.poll() is not None:
                self.fail(f"the studio ended before '{event}': {self.messages.read_text()}")
            time.sleep(0.05)
        return self.fail(f"no '{event}' {fields} in {self.events()[after:]}")

    def place_of(self, name):
        """Returns the screen position of the middle of a control where it was drawn last."""
        self.wait_for("place", name=name)
        self.display.wait_for_frames(4)  # until it no longer moves
        found = [event for event in self.events()
                 if event["event"] == "place" and event["name"] == name][-1]
        lines = self.display.tool("getwindowgeometry", "--shell", self.window).split()
        origin = dict(line.split("=") for line in lines)
        return (int(origin["X"]) + int(found["x"] + found["width"] / 2),
                int(origin["Y"]) + int(found["y"] + found["height"] / 2))

    def type_into(self, name, text):
        """Types a number into a slider, after Ctrl+click."""
        x, y = self.place_of(name)
        self.display.act(["mousemove", x, y], ["keydown", "ctrl"], ["mousedown", 1],
                         ["mouseup", 1], ["keyup", "ctrl"])
        self.type_over(text)
        self.display.tool("key", "Return")

    def click(self, name):
        x, y = self.place_of(name)
        self.display.act(["mousemove", x, y], ["mousedown", 1], ["mouseup", 1])

    def press(self, key):
        self.display.act(["keydown", key], ["keyup", key])

    def drag(self, name, from_share, to_share):
        """Drags over a control from one share of its width to another, in several steps."""
        x, y = self.place_of(name)
        width = self.wait_for("place", name=name)[0]["width"]
        steps = [x + int(width * (from_share + (to_share - from_share) * i / 5 - 0.5))
                 for i in range(6)]
        self.display.act(["mousemove", steps[0], y], ["mousedown", 1],
                         *(["mousemove", step, y] for step in steps[1:]), ["mouseup", 1])

    def type_over(self, text):
        """Replaces the content of the text field that has, or is about to get, the keyboard focus."""
        self.display.wait_for_frames(4)
        self.display.act(["keydown", "ctrl", "keydown", "a"], ["keyup", "a", "keyup", "ctrl"],
                         ["type", "--delay", "30", text])

    def save_as(self, keys, name):
        """Saves with the file panel that these keys open; returns the path."""
        after = len(self.events())
        self.display.tool("key", keys)
        self.display.wait_for_frames(4)
        self.type_over(str(self.folder / name))
        self.display.tool("key", "Return")
        return pathlib.Path(self.wait_for("saved", after=after)[0]["path"])

    def quit(self):
        self.display.tool("key", "ctrl+q")
        self.wait_for("quit")
        self.assertEqual(self.studio.wait(PATIENCE), DONE)

    def assert_painted(self, picture):
        """Checks that the picture is not blank: it has many colours in each quarter."""
        colors = subprocess.run(
            ["convert", str(picture), "-crop", "2x2@", "-format", "%k ", "info:"], check=True,
            stdout=subprocess.PIPE, encoding="utf-8").stdout.split()
        self.assertEqual(len(colors), 4)
        for count in colors:
            self.assertGreater(int(count), 16, f"colours of the quarters: {colors}")
