"""Measures how well evolution searches, in nine worlds with seeds 1 to 9, and checks the criteria.

    python3 tests/quality/measure.py build/release/bin/cambrian --out FOLDER [--seeds 1..9]
        [--trials 20000] [--random-trials 10000] [--worlds walking,ice] [--threads 2]

Performs the runs that FOLDER does not have yet (`cambrian compare`), so that it can be interrupted.
Never tune on seeds 1 to 9.
"""

import argparse
import csv
import math
import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PRESETS = HERE.parents[1] / "assets" / "settings"
WORLDS = {path.stem: path for path in [PRESETS / "walking.toml", PRESETS / "swimming.toml",
                                       PRESETS / "jumping.toml",
                                       *sorted((HERE / "worlds").glob("*.toml"))]}
DEFAULTS = "tuned"  # the arm whose settings are the defaults
BEST_PADDLER = 0.497  # BL/s, an engineered pair of two-segment paddles in the preset's water


def compare(options, folder, trials, arms, *more):
    worlds = [word for world in options.worlds for word in ["--world", WORLDS[world]]]
    subprocess.run([options.program, "compare", *arms, *worlds, *more, "--seeds", options.seeds,
                    "--trials", str(trials), "--threads", str(options.threads),
                    "--out", options.out / folder], check=True, stdout=subprocess.DEVNULL)
    with open(options.out / folder / "runs.csv", encoding="utf-8", newline="") as table:
        rows = list(csv.DictReader(table))
    return [row for row in rows if row["world"] in options.worlds
            and int(row["trials"]) == trials]


def settings_of(arm):
    return HERE / f"{arm}.toml"


def in_words(worlds, ratios, digits):
    return ", ".join(f"{world} {each:.{digits}f}" for world, each in zip(worlds, ratios))


def of(rows, world, arm, column="confirmed"):
    return [float(row[column]) for row in rows if (row["world"], row["arm"]) == (world, arm)]


def ratio(rows, world, arm, against):
    theirs = statistics.median(of(rows, world, against))
    return statistics.median(of(rows, world, arm)) / theirs if theirs > 0 else math.inf


def share_of(values):
    values = list(values)
    return f"{sum(values)} of {len(values)}", sum(values) / len(values) if values else 0.0


class Table:
    def __init__(self):
        self.lines = ["| measure | found | to reach | |", "|---|---|---|---|"]

    def add(self, measure, found, asked, holds):
        self.lines.append(f"| {measure} | {found} | {asked} | {'holds' if holds else '**fails**'} |")


def judge_strength(table, rows, random, worlds):
    ratios = [ratio(rows, world, DEFAULTS, "one-line") for world in worlds]
    mean = math.exp(statistics.fmean(math.log(max(each, 1e-9)) for each in ratios))
    table.add("best, confirmed, against one-line: geometric mean, each world",
              f"{mean:.2f}; {in_words(worlds, ratios, 2)}", "≥ 1.5, no world below 1",
              mean >= 1.5 and min(ratios) >= 1)
    for arm, founders in [("random-search", "the same founders"),
                          ("plain-random", "founders without a rhythm")]:
        ratios = [ratio(random, world, DEFAULTS, arm) for world in worlds]
        table.add(f"best against random search with {founders}", in_words(worlds, ratios, 1),
                  "≥ 4 each", min(ratios) >= 4)
    for world in worlds:
        scores = of(rows, world, DEFAULTS)
        worst = min(scores) / max(statistics.median(scores), 1e-9)
        table.add(f"{world}: worst seed against the median", f"{worst:.2f}", "≥ 0.6", worst >= 0.6)


def judge_anchors(table, rows, worlds):
    if "jumping" in worlds:
        height = statistics.median(of(rows, "jumping", DEFAULTS, "jump_height"))
        table.add("jumping: v²/2g at take-off", f"{height:.3f} m", "≥ 0.35 m", height >= 0.35)
    if "swimming" in worlds:
        scores = of(rows, "swimming", DEFAULTS)
        shares = [statistics.median(scores) / BEST_PADDLER, max(scores) / BEST_PADDLER]
        table.add("swimming against the engineered paddler: median, best seed",
                  f"{shares[0]:.2f}, {shares[1]:.2f}", "≥ 0.8, ≥ 1",
                  shares[0] >= 0.8 and shares[1] >= 1)


def judge_merit(table, rows):
    champions = [row for row in rows if row["arm"] == DEFAULTS
                 and row["world"] in ("walking", "swimming", "jumping")]
    if not champions:
        return
    score, finer, confirmed = ([float(row[name]) for row in champions]
                               for name in ["score", "finer", "confirmed"])
    found, share = share_of(abs(f - s) <= 0.1 * s for f, s in zip(finer, score))
    table.add("champions of the presets within 10 % at 1e-6, contact step a quarter", found,
              "≥ 25 of 27", share >= 25 / 27)
    kept = statistics.median(c / s if s > 0 else 1.0 for c, s in zip(confirmed, score))
    table.add("champion's median under changes of 1 %", f"{kept:.3f} of its score", "≥ 0.95",
              kept >= 0.95)


def judge_lines(table, rows):
    for column, measure, least in [("lines", "founder lines among the survivors", 5),
                                   ("plans", "body plans among the best 20 survivors", 8)]:
        values = [int(row[column]) for row in rows if row["arm"] == DEFAULTS]
        found = f"{statistics.median(values):g}, least {min(values)}"
        table.add(f"{measure}: median of all runs", found, f"≥ {least}",
                  statistics.median(values) >= least)


def judge_haste(table, rows):
    """Returns the time saved compared with the same runs without early termination."""
    hasty = [row for row in rows if row["arm"] == DEFAULTS]
    patient = [row for row in rows if row["arm"] == "patient"]
    spent = [sum(1 - float(row["time_saved"]) for row in some) / len(some)
             for some in (hasty, patient)]
    audited = sum(int(row["audited"]) for row in hasty)
    survived = sum(int(row["audited_survivors"]) for row in hasty)
    saved = 1 - spent[0] / spent[1]
    table.add("early termination: time saved; doomed that would have survived",
              f"{100 * saved:.0f} %; {survived} of {audited} audited", "≥ 25 %; ≤ 0.03 %",
              saved >= 0.25 and survived <= 0.0003 * audited)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--seeds", default="1..9")
    parser.add_argument("--trials", type=int, default=20000)
    parser.add_argument("--random-trials", type=int, default=10000)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--worlds", type=lambda names: names.split(","), default=list(WORLDS))
    options = parser.parse_args()
    for unknown in set(options.worlds) - set(WORLDS):
        sys.exit(f"unknown world {unknown}; known are {', '.join(WORLDS)}")
    rows = compare(options, "arms", options.trials,
                   map(settings_of, ["one-line", DEFAULTS, "patient"]))
    random = compare(options, "random", options.random_trials,
                     map(settings_of, [DEFAULTS, "plain-random"]), "--random-search")
    table = Table()
    judge_strength(table, rows, random, options.worlds)
    judge_anchors(table, rows, options.worlds)
    judge_merit(table, rows)
    judge_lines(table, rows)
    judge_haste(table, rows)
    text = "\n".join(table.lines) + "\n"
    (options.out / "measures.md").write_text(text, encoding="utf-8")
    print(text, end="")


if __name__ == "__main__":
    main()
