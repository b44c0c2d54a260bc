"""Runs preserves for a long time of their world and looks at them every 10 s of it. Fails if the sum
of all energy is ever another one, by a billionth of a joule or more, if the program ends by itself,
or if its memory grows by more than 5 % from the second quarter of the time to the last. The lowest
memory of each quarter counts, since it follows the population at times. Prints a row for each tenth
of the time, as CSV, and at the end the memory and how many of the worlds still have creatures.

    CAMBRIAN=build/release/bin/cambrian python3 -B tests/cli/preserve_soak.py --hours 10 \\
        --settings assets/settings/pond.toml --founders assets/creatures/squid.creature.json
    ... --hours 1 --seeds 1 2 3 4 5 --without-restocking
"""

import argparse
import decimal
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("CAMBRIAN", str(ROOT / "build/release/bin/cambrian"))
GROWTH = 1.05
ROW = 10  # s, between two lines of the program
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


def run(seed, options):
    """Runs one world. Returns the last line of the program and the memory at each."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        command = [PROGRAM, "preserve", settings_of(options, folder), "--json", "--seed", str(seed),
                   "--seconds", str(3600 * options.hours), "--threads", str(options.threads),
                   "--out", folder / "world.cambrian"]
        if options.founders:
            command += ["--founders", *options.founders]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        total, memory, sums, line = None, [], Sums(), None
        every = max(1, round(3600 * options.hours / ROW / 10))
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
        assert len(memory) == int(3600 * options.hours / ROW), f"seed {seed}: it ended too early"
        print(f"# seed {seed}: {total} J at each of {len(memory)} looks", flush=True)
        return line, memory


def check_memory(seed, memory):
    quarter = len(memory) // 4
    early, late = min(memory[quarter:2 * quarter]), min(memory[-quarter:])
    print(f"# seed {seed}: {early / 1e6:.1f} MB in the second quarter, {late / 1e6:.1f} MB in the "
          "last")
    return late < early * GROWTH


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--settings", default=str(ROOT / "assets/settings/pond.toml"))
    parser.add_argument("--founders", nargs="*", default=[])
    parser.add_argument("--hours", type=float, default=10.0, help="time of each world")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1])
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--without-restocking", action="store_true")
    options = parser.parse_args()
    print(COLUMNS)
    flat, alive = True, 0
    for seed in options.seeds:
        last, memory = run(seed, options)
        flat = check_memory(seed, memory) and flat
        alive += last["population"] > 0
    print(f"# {alive} of {len(options.seeds)} worlds are alive")
    if not flat:
        sys.exit("the memory grows")


if __name__ == "__main__":
    main()
