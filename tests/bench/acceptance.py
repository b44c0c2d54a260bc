#!/usr/bin/env python3
"""Checks speed and accuracy of our physics against their bounds and prints one Markdown table.

    acceptance.py [--bin build/release/bin] [--parts instructions audit ...] [--quick]

Runs the benchmarks of this folder (built with CAMBRIAN_BUILD_BENCH) with the program's default
settings and prints each figure with its bound. The counts of instructions need valgrind. Timed rows
need an idle machine; all others are the same on any machine. `--quick` runs few creatures for a
short time: it shows that everything works, but its figures are not reliable.
"""

import argparse
import csv
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
BODIES = [3, 6, 12, 24]
WORKLOADS = {"air": "air", "swim": "water", "walk": "walking"}
GOALS = ["walking", "swimming", "jumping"]
LEAST_SPEEDUP = {"air": [3.0, 3.3, 3.5, 3.8], "swim": [2.2, 2.8, 2.9, 4.4],
                 "walk": [2.0, 2.2, 2.2, 2.0]}
CPU_TIME_SHARE = 0.9  # share of the speedup in instructions that the speedup in CPU time must reach
CHAMPION_SEEDS = range(1, 10)


@dataclass
class Row:
    """One row of the table: its figures, one per size or a single one, and their bound (None: no
    bound)."""
    what: str
    figures: list
    least: list = None
    most: list = None

    def missed(self):
        """Returns the indices of the figures beyond the bound. A figure that is not a number counts
        as beyond."""
        def held(i, x):
            if self.least is not None:
                return self.least[i] is None or x >= self.least[i]
            return self.most[i] is None or x <= self.most[i]
        return [i for i, x in enumerate(self.figures) if not held(i, x)]

    def verdict(self):
        if self.least is None and self.most is None:
            return ""
        missed = self.missed()
        if not missed:
            return "ok"
        if len(self.figures) == 1 or len(missed) == len(self.figures):
            return "missed"
        return "missed at " + ", ".join(str(BODIES[i]) for i in missed)

    def bound(self):
        for words, bound in [("at least ", self.least), ("at most ", self.most)]:
            if bound is not None:
                same = len(set(bound)) == 1
                return words + " / ".join(map(number, bound[:1] if same else bound))
        return ""

    def line(self):
        figures = " / ".join(number(x) for x in self.figures)
        return f"| {self.what} | {figures} | {self.bound()} | {self.verdict()} |"


def number(value):
    if value is None:
        return "–"
    if isinstance(value, int) or not math.isfinite(value):
        return str(value)
    if value != 0 and not 1e-3 <= abs(value) < 1e4:
        mantissa, exponent = f"{value:.1e}".split("e")
        return f"{float(mantissa):g}e{int(exponent)}"
    return f"{value:.4g}" if abs(value) >= 1000 else f"{value:.3g}"


class Bench:
    """Runs the programs and reads their tables."""

    def __init__(self, options, folder):
        self.bin = pathlib.Path(options.bin).resolve()
        self.quick = options.quick
        self.threads = options.threads
        self.folder = folder

    def run(self, *command, **variables):
        result = subprocess.run([str(part) for part in command], text=True, check=False,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env=dict(os.environ, **variables))
        if result.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))} failed:\n{result.stdout}{result.stderr}")
        return result.stdout

    def table(self, name, program, *arguments):
        """Returns the CSV table that one of our programs writes."""
        path = self.folder / f"{name}.csv"
        self.run(self.bin / program, *arguments, "--csv", path)
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))


def by_bodies(table, column, **wanted):
    """Returns the column's figures of the rows with these values, one per size."""
    found = {int(row["bodies"]): float(row[column]) for row in table
             if all(row[key] == value for key, value in wanted.items())}
    return [found[size] for size in BODIES]


def instructions(bench):
    sizes = {"CREATURES": "1", "SECONDS_SIMULATED": "1"} if bench.quick else {}
    text = bench.run("sh", HERE / "count_instructions.sh", bench.bin / "cambrian_bench_engines",
                     bench.folder / "profiles", ENGINES="cambrian box2d box2d-torques", **sizes)
    table = list(csv.DictReader(text.splitlines()))
    (bench.folder / "instructions.csv").write_text(text, encoding="utf-8")
    for workload, name in WORKLOADS.items():
        yield Row(f"instructions, Box2D / ours, {name}",
                  by_bodies(table, "ratio", workload=workload, engine="box2d"),
                  least=LEAST_SPEEDUP[workload])
    for workload, name in WORKLOADS.items():
        yield Row(f"the same, its motors as torques, {name}",
                  by_bodies(table, "ratio", workload=workload, engine="box2d-torques"))
    for workload, name in WORKLOADS.items():
        yield Row(f"ours, million instructions a simulated second, {name}",
                  by_bodies(table, "million_per_second", workload=workload, engine="cambrian"))


def cpu_time(bench):
    sizes = ["--creatures", 2, "--seconds", 1] if bench.quick else ["--rounds", 7]
    table = bench.table("cpu_time", "cambrian_bench_engines", "--engine", "cambrian", "box2d",
                        *sizes)
    for workload, name in WORKLOADS.items():
        yield Row(f"CPU time, Box2D / ours, {name}",
                  by_bodies(table, "ratio", workload=workload, engine="box2d"),
                  least=[CPU_TIME_SHARE * x for x in LEAST_SPEEDUP[workload]])


def throughput(bench):
    least = {"walking": 2.0, "swimming": 3.5, "jumping": 2.0}
    sizes = ["--generations", 1, "--size", 20] if bench.quick else []
    for goal in GOALS:
        table = bench.table(f"throughput_{goal}", "cambrian_bench_throughput",
                            ROOT / f"assets/settings/{goal}.toml", "--threads", bench.threads,
                            *sizes)
        figures = {row["figure"]: float(row["value"]) for row in table}
        yield Row(f"million evaluations an hour and core, {goal}",
                  [figures["evaluations_an_hour_and_core"] / 1e6], least=[least[goal]])
        yield Row(f"percent of an evaluation that is not physics, {goal}",
                  [figures["percent_not_physics"]], most=[10.0])


def soundness(bench):
    sizes = ["--creatures", 3, "--seconds", 2] if bench.quick else []
    table = bench.table("accuracy", "cambrian_bench_accuracy", "--threads", bench.threads, *sizes)
    # Few creatures do not tell: the median of 20 varies by a quarter from one twenty to another.
    angles = bench.table("angles", "cambrian_bench_accuracy", "--threads", bench.threads,
                         "--measure", "angles", "--creatures", 3 if bench.quick else 1600)

    def figures(measure, workload, figure):
        return by_bodies(table, "value", measure=measure, workload=workload, figure=figure)

    def everywhere(measure, figure):
        return [max(sizes) for sizes in zip(*(figures(measure, each, figure)
                                              for each in WORKLOADS))]

    yield Row("widest joint gap, m", everywhere("gap", "widest m"), most=[1e-12] * 4)
    yield Row("centre of mass moved by muscles in empty space, m",
              figures("momentum", "empty", "farthest m"), most=[1e-10] * 4)
    yield Row("angular momentum muscles make in empty space, share of the parts'",
              figures("momentum", "empty", "angular share"))
    yield Row("joint angles after 0.5 s of walking, median error, 1e-3 rad",
              [1e3 * x for x in by_bodies(angles, "value", workload="walk")],
              most=[3.0, 5.0, 9.0, 15.0])
    yield Row("energy given by contacts and stops, walking, % of the scale",
              figures("audit", "walk", "percent given"), most=[0.7, 0.55, 0.7, 0.95])
    for workload in ["air", "swim"]:
        yield Row(f"mirror images after 10 s, {WORKLOADS[workload]}, worst, m",
                  figures("mirror", workload, "worst m"), most=[1e-11] * 4)
    yield Row("mirror images after 10 s, walking, median, m",
              figures("mirror", "walk", "median m"), most=[1e-9, 1e-9, 1e-9, None])
    for workload, name in WORKLOADS.items():
        yield Row(f"evaluations a simulated second, {name}",
                  figures("audit", workload, "evaluations a second"))
    for workload, name in WORKLOADS.items():
        yield Row(f"steps a simulated second, {name}",
                  figures("audit", workload, "steps a second"))


def fallbacks(bench):
    """Returns nothing if the program that counts them is not built."""
    program = bench.bin / "cambrian_bench_rows"
    if not program.exists():
        return
    sizes = ["-n", 2, "--seconds", 2] if bench.quick else []
    told = bench.run(program, "--threads", bench.threads, *sizes)
    # The output has one line per size; its last column is the share of all problems.
    found = {int(size): float(percent)
             for size, percent in re.findall(r"^ *(\d+) .*\| +([\d.]+) %$", told, re.MULTILINE)}
    yield Row("row problems that fall back to sweeps, walking, %",
              [found[size] for size in BODIES], most=[0.1, 0.1, 0.5, 2.0])


def violence(bench):
    creatures = 200 if bench.quick else 10000
    table = bench.table("violence", "cambrian_bench_robustness", "-n", creatures,
                        "--threads", bench.threads)
    count = lambda is_so: sum(1 for row in table if is_so(row))
    worst = lambda column: max(float(row[column]) for row in table)
    running, invalid, over_budget = "0", "1", "2"
    kind = f"{creatures} violent creatures"
    yield Row(f"{kind}: invalid", [count(lambda row: row["status"] == invalid)], most=[0])
    yield Row(f"{kind}: over budget", [count(lambda row: row["status"] == over_budget)], most=[0])
    yield Row(f"{kind}: not finite",
              [count(lambda row: row["status"] == running and row["verdict"] == "invalid")],
              most=[0])
    yield Row(f"{kind}: deepest contact, cm", [100 * worst("penetration_m")], most=[5.0])
    yield Row(f"{kind}: farthest beyond a limit, rad", [worst("limit_overrun")], most=[0.08])
    suspects = [row for row in table if row["verdict"] == "suspect"]
    yield Row(f"{kind}: suspect, %", [100 * len(suspects) / len(table)], most=[0.1])
    yield Row(f"{kind}: suspect after recomputation",
              [sum(1 for row in suspects if row["finer_verdict"] != "clean")], most=[0])
    yield Row(f"{kind}: most evaluations a simulated second", [worst("evaluations_per_s")],
              most=[1000.0])


def resting(table, creatures):
    """Returns the percentages of the first creatures of each size that come to rest."""
    return [100 * sum(1 for row in table if int(row["bodies"]) == size
                      and int(row["seed"]) < creatures and row["completed"] == "1"
                      and float(row["early_speed"]) <= 1e-3) / creatures for size in BODIES]


def rest(bench):
    """Some creatures still sink slowly after nine seconds, also in a precise computation."""
    few, many = (10, 20) if bench.quick else (100, 1000)
    holding = ["cambrian_bench_robustness", "--pose", "-n", many, "--threads", bench.threads]
    table = bench.table("rest", *holding)
    precise = bench.table("precise_rest", *holding, "--integrator", "dormand-prince",
                          "--tolerance", 1e-6, "--contact-step", 1 / 480)
    expected = resting(precise, many)
    yield Row(f"{few} pose holders below 1 mm/s at 9 to 10 s, %", resting(table, few),
              least=[100, 100, 99, 97])
    yield Row(f"{many} pose holders, the same", resting(table, many),
              least=[x - 1 for x in expected])
    yield Row(f"{many} pose holders, the same in a precise computation", expected)


def finer_loss(bench, seed):
    """Returns the percentage of its score that the champion of a default run of walking loses when
    it is computed with Dormand-Prince at 1e-6 and a quarter of the contact step."""
    champion = bench.folder / f"walking-{seed}.creature.json"
    settings = bench.folder / "walking.toml"
    settings.write_text(bench.run(bench.bin / "cambrian", "settings"), encoding="utf-8")
    shorter = ["--generations", 3] if bench.quick else []
    bench.run(bench.bin / "cambrian", "evolve", settings, "--seed", seed, *shorter,
              "--threads", bench.threads, "--out", champion)
    creature = json.loads(champion.read_text(encoding="utf-8"))
    score = creature["scored"]["fitness"]
    simulation = creature["scored"]["simulation"]
    simulation.update({"integrator": "dormand-prince", "tolerance": 1e-6,
                       "contact-step": simulation["contact-step"] / 4, "max-evaluations": 1e6})
    finer = bench.folder / f"finer-{seed}.creature.json"
    finer.write_text(json.dumps(creature), encoding="utf-8")
    report = json.loads(bench.run(bench.bin / "cambrian", "simulate", finer, "--json"))
    return 100 * (1 - report["fitness"] / score)


def champions(bench):
    losses = [finer_loss(bench, seed) for seed in CHAMPION_SEEDS]
    for seed, loss in zip(CHAMPION_SEEDS, losses):
        yield Row(f"champion of default walking, seed {seed}: score lost at finer settings, %",
                  [loss])
    yield Row("median of these champions' losses, %", [statistics.median(losses)], most=[11.0])


PARTS = {part.__name__: part for part in
         [instructions, cpu_time, throughput, soundness, fallbacks, violence, rest, champions]}
USUAL = [name for name in PARTS if name != "champions"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--bin", default=ROOT / "build/release/bin",
                        help="folder of the programs")
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=USUAL,
                        help="all but champions, which take some minutes each, by default")
    parser.add_argument("--quick", action="store_true", help="few creatures, a short time")
    parser.add_argument("--threads", type=int, default=1,
                        help="of everything but the timed rows of engines")
    parser.add_argument("--keep", type=pathlib.Path,
                        help="folder for profiles, tables and champions")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="cambrian-acceptance-") as temporary:
        folder = options.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        bench = Bench(options, folder)
        if options.quick:
            print("Few creatures for a short time: not to be judged by.\n")
        print("| figure (3 / 6 / 12 / 24 bodies) | found | to reach | |\n|---|---|---|---|")
        rows = []
        for name in options.parts:
            for row in PARTS[name](bench):
                rows.append(row)
                print(row.line(), flush=True)
    missed = sum(1 for row in rows if row.verdict().startswith("missed"))
    held = sum(1 for row in rows if row.verdict() == "ok")
    print(f"\n{held} bounds hold, {missed} are missed.")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
