"""Runs preserves for a long time of their world and looks at them every 10 s of it. Fails if the sum
of all energy is ever another one, by a billionth of a joule or more, if the program ends by itself,
if its memory grows by more than 5 % from the second quarter of the time to the last, or if at the end
it holds 5 % more than a program that goes on with the same world from its file. The lowest memory of
each quarter counts, since it follows the population at times; the second comparison tells growth of
the world from memory that the program lost. Prints a row for each tenth of the time, as CSV, and at
the end the memory and how many of the worlds still have creatures. A soak by the clock stops after so
many hours; with a folder its worlds are kept there, and the next soak goes on with them.

    CAMBRIAN=build/release/bin/cambrian python3 -B tests/cli/preserve_soak.py --hours 10 \\
        --settings assets/settings/pond.toml --founders assets/creatures/squid.creature.json
    ... --hours 1 --seeds 1 2 3 4 5 --without-restocking
    ... --hours 1000 --clock-hours 2 --worlds build/ponds --rows-every 600
"""

import argparse
import decimal
import itertools
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("CAMBRIAN", str(ROOT / "build/release/bin/cambrian"))
GROWTH = 1.05
ROW = 10  # s, between two lines of the program
SETTLED = 12  # rows after which the memory of a program that resumes a world is compared
COLUMNS = ("seed,hours,population,lineages,births,hunger,eaten,broken_physics,restocked,speed,"
           "diet,mass,parts,light,plants,flesh,stores,bodies,times_real,megabytes")


def resident_memory(process):
    """Returns the resident memory of a process, in bytes."""
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    return 1024 * int(re.search(r"VmRSS:\s+(\d+)", status)[1])


def settings_of(options, folder):
    text = pathlib.Path(options.settings).read_text()
    if options.without_restocking:
        text, changes = re.subn(r"(?m)^restock = \d+", "restock = 0", text)
        assert changes == 1, f"{options.settings} has no line of restock"
    path = folder / "settings.toml"
    path.write_text(text)
    return path


class Sums:
    """What happened since the last row that was printed."""

    def __init__(self):
        self.births = self.restocked = 0
        self.deaths = {"hunger": 0, "eaten": 0, "broken physics": 0}

    def add(self, line):
        self.births += line["births"]
        self.restocked += line["restocked"]
        for cause in self.deaths:
            self.deaths[cause] += line["deaths"][cause]


def print_row(seed, line, sums, memory):
    means = [f"{float(line[name]):.3f}" for name in ("speed", "diet", "mass", "parts")]
    energies = [f"{line['energy'][name]:.0f}" for name in
                ("light", "plants", "flesh", "stores", "bodies")]
    print(seed, f"{line['time'] / 3600:.2f}", line["population"], line["lineages"], sums.births,
          *sums.deaths.values(), sums.restocked, *means, *energies,
          f"{float(line['real_time_factor']):.1f}", f"{memory / 1e6:.1f}", sep=",", flush=True)


def world_of(seed, options, folder):
    """Returns the file of a world."""
    return pathlib.Path(options.worlds or folder) / f"seed_{seed}.cambrian"


def program_of(options):
    """Returns the part of the command line that beginning and going on with a world share."""
    return [PROGRAM, "preserve", "--json", "--threads", str(options.threads)]


def command_of(seed, options, folder):
    """Returns the command line that begins a world or goes on with one that is kept."""
    world = world_of(seed, options, folder)
    world.parent.mkdir(parents=True, exist_ok=True)
    command = program_of(options) + ["--seconds", str(3600 * options.hours)]
    if world.exists():
        return command + ["--resume", world]
    command += [settings_of(options, folder), "--seed", str(seed), "--out", world]
    return command + (["--founders", *options.founders] if options.founders else [])


def print_times(seed, looks, begun):
    """Says how long the program ran; its processor time is that of all the worlds so far."""
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"# seed {seed}: {looks * ROW / 3600:.2f} h of the world in "
          f"{(time.monotonic() - begun) / 3600:.2f} h; {(spent.ru_utime + spent.ru_stime) / 3600:.2f}"
          " h of processor time up to here")


def resumed_memory(seed, options, folder):
    """Returns the lowest memory of a program that goes on with a world, once it has settled."""
    command = program_of(options) + ["--resume", world_of(seed, options, folder)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    memory = [resident_memory(process) for _ in itertools.islice(process.stdout, 2 * SETTLED)]
    process.send_signal(signal.SIGINT)
    process.communicate()
    assert process.returncode == 0, f"seed {seed}: the program ended by itself when it went on"
    return min(memory[SETTLED:])


def run(seed, options):
    """Runs one world. Returns the last line of the program, the memory at each line, and that of
    another program that goes on with the world."""
    with tempfile.TemporaryDirectory() as name:
        begun = time.monotonic()
        process = subprocess.Popen(command_of(seed, options, pathlib.Path(name)),
                                   stdout=subprocess.PIPE, text=True)
        if options.clock_hours:
            clock = threading.Timer(3600 * options.clock_hours, process.send_signal,
                                    [signal.SIGINT])
            clock.daemon = True
            clock.start()
        total, memory, sums, line = None, [], Sums(), None
        every = max(1, round((options.rows_every or 360 * options.hours) / ROW))
        for text in process.stdout:
            line = json.loads(text, parse_float=decimal.Decimal)
            memory.append(resident_memory(process))
            energy = sum(line["energy"].values())
            total = total or energy
            assert energy == total, f"seed {seed}, {line['time']} s: {energy} J, not {total} J"
            sums.add(line)
            if len(memory) % every == 0:
                print_row(seed, line, sums, memory[-1])
                sums = Sums()
        assert process.wait() == 0, f"seed {seed}: the program ended by itself"
        print_times(seed, len(memory), begun)
        asked = int(3600 * options.hours / ROW)
        assert options.clock_hours or line["time"] >= ROW * asked, f"seed {seed}: it ended too early"
        print(f"# seed {seed}: {total} J at each of {len(memory)} looks", flush=True)
        return line, memory, resumed_memory(seed, options, pathlib.Path(name))


def check_memory(seed, memory, resumed):
    quarter = len(memory) // 4
    early, late = min(memory[quarter:2 * quarter]), min(memory[-quarter:])
    print(f"# seed {seed}: {early / 1e6:.1f} MB in the second quarter, {late / 1e6:.1f} MB in the "
          "last")
    end = min(memory[-SETTLED:])
    print(f"# seed {seed}: {end / 1e6:.1f} MB at the end, {resumed / 1e6:.1f} MB in a program that "
          "goes on with it")
    return late < early * GROWTH and end < resumed * GROWTH


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--settings", default=str(ROOT / "assets/settings/pond.toml"))
    parser.add_argument("--founders", nargs="*", default=[])
    parser.add_argument("--hours", type=float, default=10.0, help="time of each world")
    parser.add_argument("--clock-hours", type=float, help="time of the clock for each world")
    parser.add_argument("--worlds", help="folder of worlds that are kept")
    parser.add_argument("--rows-every", type=float, help="time of the world between rows, in s")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1])
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--without-restocking", action="store_true")
    options = parser.parse_args()
    print(COLUMNS)
    flat, alive = True, 0
    for seed in options.seeds:
        last, memory, resumed = run(seed, options)
        flat = check_memory(seed, memory, resumed) and flat
        alive += last["population"] > 0
    print(f"# {alive} of {len(options.seeds)} worlds are alive")
    if not flat:
        sys.exit("the memory grows")


if __name__ == "__main__":
    main()
