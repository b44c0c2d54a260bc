"""Measures how responsive the studio is during evolution: the real program in a window on a virtual
display, with OpenGL in software, timed by its own logs. See README.md in this folder."""

import argparse
import csv
import json
import mmap
import os
import pathlib
import shutil
import statistics
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/cli"))
from nats_server import NatsServer  # noqa: E402: its folder is added to the path above
PATIENCE = 60  # s; for the window to open, to respond and to close
LONG_FRAME = 33.0  # ms
INPUT_EVERY = 3.0  # s
F1 = 290  # GLFW key code
PACES = 4  # presses that lead from any pace of a preserve to the fastest
TICKS_PER_SECOND = 60

# name: (upper bound, unit)
AIMS = {
    "frames over 33 ms": (5.0, "%"),
    "longest frame": (100.0, "ms"),
    "start to first frame": (1000.0, "ms"),
    "input to visible effect": (2.0, "frames"),
    "memory": (300.0, "MB"),
}

EVOLVING = "[population]\nsize = {size}\n"
IN_SPACE = "[goal]\nbehavior = \"swimming\"\n[environment]\ndimensions = 3\n"
# What is stored of a creature does not depend on the length of its trial. With short trials, the
# generation at which memory is read is reached within minutes.
QUICK = EVOLVING + "[trial]\nduration = 1\n"


class Display:
    """A separate virtual X display whose pixels can be read while they change."""

    def __init__(self, folder, options):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0",
             f"{options.width}x{options.height}x24", "-fbdir", str(folder), "-nolisten", "tcp"], pass_fds=[writing],
            stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as numbers:
            name = ":" + numbers.readline().strip()
        self.environment = dict(os.environ, DISPLAY=name, LIBGL_ALWAYS_SOFTWARE="1")
        with (folder / "Xvfb_screen0").open("rb") as file:
            self.screen = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        # The head of an XWD file contains its own length and, further on, the bytes per row of
        # pixels and the number of colours between head and pixels, 12 bytes each.
        head = struct.unpack(">25I", self.screen[:100])
        self.first_pixel, self.line = head[0] + 12 * head[19], head[12]

    def pixel(self, x, y):
        place = self.first_pixel + y * self.line + 4 * x
        return self.screen[place:place + 3]

    def tool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True,
                              stdout=subprocess.PIPE, encoding="utf-8", timeout=PATIENCE).stdout

    def close(self):
        self.server.terminate()
        self.server.wait(PATIENCE)


class Cluster:
    """A server and workers of one core each, on this machine. They run by the idle policy: other
    machines would take nothing of this one's cores, and these take only what the window leaves."""

    def __init__(self, folder, options):
        os.sched_setscheduler(0, os.SCHED_IDLE, os.sched_param(0))  # whatever is started has it
        self.server = NatsServer(folder / "server")
        self.workers = [
            subprocess.Popen([options.program, "worker", self.server.url, "--threads", "1",
                              "--name", f"worker {i}"], stdin=subprocess.DEVNULL,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            for i in range(options.workers)]
        os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))

    def close(self):
        for worker in self.workers:
            worker.terminate()
        for worker in self.workers:
            worker.wait(PATIENCE)
        self.server.stop()


class Studio:
    """The program in a window, with its logs in a folder."""

    def __init__(self, display, folder, options, *arguments):
        self.display = display
        self.options = options
        self.frame_log = folder / "frames.csv"
        self.status_log = folder / "status.log"
        self.status_log.unlink(missing_ok=True)
        command = [options.program, "studio", *arguments, "--width", options.width,
                   "--height", options.height, "--scenery", options.scenery,
                   "--state-dir", "", "--frame-log", self.frame_log,
                   "--status-log", self.status_log]
        if options.threads:
            command += ["--threads", options.threads]
        self.launched = time.monotonic()
        self.process = subprocess.Popen(list(map(str, command)), env=display.environment)
        self.wait_for("started")
        self.window = display.tool("search", "--sync", "--name", "Cambrian").split()[0]
        display.tool("windowfocus", "--sync", self.window)

    def events(self, name):
        if not self.status_log.exists():
            return []
        whole_lines = self.status_log.read_text().split("\n")[:-1]
        return [event for event in map(json.loads, whole_lines) if event["event"] == name]

    def wait_for(self, name, count=1, patience=PATIENCE):
        """Returns the last of `count` events of this name."""
        end = time.monotonic() + patience
        while time.monotonic() < end:
            found = self.events(name)
            if len(found) >= count:
                return found[count - 1]
            if self.process.poll() is not None:
                sys.exit(f"the studio ended before '{name}'")
            time.sleep(0.05)
        return sys.exit(f"no '{name}' within {patience} s")

    def memory(self):
        """Returns the resident memory in MB."""
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        resident = next(line for line in status.splitlines() if line.startswith("VmRSS:"))
        return int(resident.split()[1]) / 1024

    def frames(self):
        """Returns the logged frames; they are complete when the program has ended."""
        with self.frame_log.open(newline="") as file:
            return [{name: float(value) for name, value in row.items()}
                    for row in csv.DictReader(file)]

    def close(self):
        self.display.tool("key", "ctrl+q")
        self.process.wait(PATIENCE)


class Toggle:
    """The help card, which F1 opens and closes. Records the time of each press and the time at
    which the screen showed its effect."""

    def __init__(self, studio):
        self.studio = studio
        # A point in the margin of the card, in the middle of the window; the viewport is behind it.
        options = studio.options
        self.place = (options.width // 2 - 420, options.height // 2 - 310)
        self.pressed = 0
        self.seen = []  # (index of the press, s when visible)
        without = self.studio.display.pixel(*self.place)
        self.press()
        time.sleep(1.0)
        self.colors = [without, self.studio.display.pixel(*self.place)]
        if self.colors[0] == self.colors[1]:
            sys.exit("F1 brings no help card")

    def press(self):
        self.studio.display.tool("key", "F1")
        self.pressed += 1

    def press_and_watch(self):
        self.studio.display.tool("keydown", "F1")
        self.pressed += 1
        wanted = self.pressed % 2
        end = time.monotonic() + PATIENCE
        while self.studio.display.pixel(*self.place) != self.colors[wanted]:
            if time.monotonic() > end:
                sys.exit("F1 has no visible effect")
            time.sleep(0.0005)
        self.seen.append((self.pressed, time.monotonic()))
        self.studio.display.tool("keyup", "F1")

    def frames(self):
        """For each press that was seen: the number of frames from the one that read it to the one
        that showed its effect, both included."""
        begun = self.studio.frames()
        presses = [event for event in self.studio.events("pressed") if event["key"] == F1]
        return [sum(frame["began_s"] <= seen and frame["frame"] >= presses[press - 1]["frame"]
                    for frame in begun)
                for press, seen in self.seen]


def evolving(display, folder, options, settings, cluster=None):
    """Returns a studio that evolves from its start on."""
    settings_file = folder / "settings.toml"
    settings_file.write_text((IN_SPACE if options.space else "") + settings)
    served = ["--cluster", cluster.server.url] if cluster else []
    return Studio(display, folder, options, settings_file, "--evolve", *served)


def living(display, folder, options):
    """Returns a studio whose preserve, a copy of the given one, goes on as fast as it can."""
    studio = Studio(display, folder, options, shutil.copy(options.preserve, folder))
    studio.wait_for("preserve")
    display.tool("key", "space", *["bracketright"] * PACES)
    return studio


def quantile(values, share):
    ordered = sorted(values)
    return ordered[round(share * (len(ordered) - 1))]


def measure_frames(display, folder, options, cluster):
    """Evolves for some time while the help card opens and closes in front of the table of
    machines."""
    studio = evolving(display, folder, options, EVOLVING.format(size=options.size), cluster)
    if cluster:
        while studio.events("machines")[-1]["machines"] <= options.workers:
            studio.wait_for("machines", count=len(studio.events("machines")) + 1)
    display.tool("key", "ctrl+m")
    toggle, memory = watch(studio, options)
    generations = len(studio.events("generation"))
    return figures_of(studio, toggle, f"{options.seconds:.0f} s, {generations} generations of "
                      f"{options.size}, {memory:.0f} MB at the end")


def measure_preserve(display, folder, options):
    """Lets a preserve go on for some time while the help card opens and closes."""
    studio = living(display, folder, options)
    toggle, memory = watch(studio, options)
    first, last = (studio.events("world")[at] for at in (0, -1))
    seconds = (last["tick"] - first["tick"]) / TICKS_PER_SECOND
    return figures_of(studio, toggle, f"{options.seconds:.0f} s, {seconds:.0f} s of the world with "
                      f"{last['creatures']} creatures, {memory:.0f} MB at the end")


def watch(studio, options):
    """Opens and closes the help card until the time is over. Returns the presses and the memory,
    and closes the studio."""
    end = studio.launched + options.seconds
    time.sleep(5.0)
    toggle = Toggle(studio)
    while time.monotonic() < end:
        time.sleep(INPUT_EVERY)
        toggle.press_and_watch()
    memory = studio.memory()
    studio.close()
    return toggle, memory


def figures_of(studio, toggle, duration):
    frames = studio.frames()
    intervals = [frame["interval_ms"] for frame in frames]
    work = [frame["work_ms"] for frame in frames]
    steps = toggle.frames()
    print(f"frames                   {len(frames)} in {duration}")
    for name, values in (("frame time", intervals), ("work of it", work)):
        print(f"{name:24} median {statistics.median(values):.1f}, p95 {quantile(values, 0.95):.1f},"
              f" p99 {quantile(values, 0.99):.1f}, longest {max(values):.1f} ms")
    print(f"presses watched          {len(steps)}: {' '.join(map(str, steps))} frames")
    return {
        "frames over 33 ms": 100 * sum(each > LONG_FRAME for each in intervals) / len(intervals),
        "longest frame": max(intervals),
        "start to first frame": 1000 * (frames[0]["shown_s"] - studio.launched),
        "input to visible effect": statistics.median(steps),
    }


def measure_memory(display, folder, options):
    studio = evolving(display, folder, options, QUICK.format(size=options.size))
    for passed in range(50, options.generations + 1, 50):
        studio.wait_for("generation", count=passed, patience=3600)
        print(f"memory                   {studio.memory():.0f} MB after {passed} generations")
    memory = studio.memory()
    studio.close()
    return {"memory": memory}


def warm_up(display, folder, options):
    """Loads the program's files into memory before its start is timed."""
    evolving(display, folder, options, EVOLVING.format(size=options.size)).close()


def judge(figures):
    missed = 0
    for name, (most, unit) in AIMS.items():
        if name not in figures:
            continue
        well = figures[name] <= most
        missed += not well
        print(f"{'met   ' if well else 'MISSED'} {name:24} {figures[name]:.1f} {unit}, "
              f"at most {most:.0f}")
    return missed


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", nargs="?", default=ROOT / "build/release/bin/cambrian")
    parser.add_argument("--seconds", type=float, default=60.0, help="how long frames are timed")
    parser.add_argument("--width", type=int, default=1920, help="of the window, in pixels")
    parser.add_argument("--height", type=int, default=1080)
    parser.add_argument("--scenery", default="automatic", help="as the studio has it")
    parser.add_argument("--size", type=int, default=300, help="creatures in the population")
    parser.add_argument("--threads", type=int, help="that evaluate; one a core unless given")
    parser.add_argument("--workers", type=int, default=0,
                        help="evaluate with so many workers on this machine too, through a server")
    parser.add_argument("--space", action="store_true", help="evolves in three dimensions")
    parser.add_argument("--preserve", type=pathlib.Path, metavar="WORLD.cambrian",
                        help="let this preserve go on as fast as it can instead of evolving")
    parser.add_argument("--generations", type=int, default=0,
                        help="read the memory after so many quick ones too; 0 does not")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="cambrian-frames-") as name:
        folder = pathlib.Path(name)
        display = Display(folder, options)
        try:
            print(f"load before              {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
            warm_up(display, folder, options)
            cluster = Cluster(folder, options) if options.workers else None
            try:
                figures = (measure_preserve(display, folder, options) if options.preserve
                           else measure_frames(display, folder, options, cluster))
            finally:
                if cluster:
                    cluster.close()
            if options.generations:
                figures |= measure_memory(display, folder, options)
        finally:
            display.close()
    sys.exit(1 if judge(figures) else 0)


if __name__ == "__main__":
    main()
