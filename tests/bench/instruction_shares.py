#!/usr/bin/env python3
"""Sums the instructions of kept profiles by subject, as a Markdown table.

The profiles are those of count_instructions.sh FOLDER, for a program with the lines of its source:

    cmake --preset release -B build/lines -DCAMBRIAN_BUILD_BENCH=ON -DCMAKE_CXX_FLAGS=-g
    cmake --build build/lines --target cambrian_bench_engines
    ENGINES=cambrian tests/bench/count_instructions.sh build/lines/bin/cambrian_bench_engines FOLDER
    tests/bench/instruction_shares.py FOLDER

What is inlined counts where it is written, so vector operations and elementary functions have a row of
their own. The profiles also have the building of the scenes, once in three simulated seconds.
"""

import collections
import pathlib
import re
import subprocess
import sys

from acceptance import BODIES, WORKLOADS

# A source belongs to the first subject with one of its folders or names.
SUBJECTS = (
    ("row solver", ("complementarity_solver", "row_factors")),
    ("rows and their matrix", ("constraints/",)),
    ("contact detection", ("contact/",)),
    ("equations of motion", ("articulated/", "evaluation/", "forces/", "model/kinematics", "model/motion")),
    ("steps and energy balance", ("stepping/", "integrators/", "planar_scene")),
    ("vectors and elementary functions", ("model/simd.h", "elementary.h")),
)
REST = "building the scenes, everything else"


def subject_of(source):
    for subject, places in SUBJECTS:
        if any(place in source for place in places):
            return subject
    return REST


def shares_of(profile):
    """Returns the percentage of each subject."""
    if not profile.is_file():
        sys.exit(f"instruction_shares.py: {profile}: no such profile; count_instructions.sh makes it")
    listed = subprocess.run(["callgrind_annotate", "--auto=no", "--threshold=100", profile],
                            capture_output=True, text=True, check=True).stdout
    counts = collections.Counter()
    for count, source in re.findall(r"^\s*([\d,]+) \([ \d.]+%\)\s+(\S+?):", listed, re.MULTILINE):
        counts[subject_of(source)] += int(count.replace(",", ""))
    if not counts:
        sys.exit(f"instruction_shares.py: {profile} lists no functions; expected a profile of callgrind")
    total = sum(counts.values())
    return {subject: 100.0 * count / total for subject, count in counts.items()}


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: instruction_shares.py FOLDER")
    folder = pathlib.Path(sys.argv[1])
    print("| % of all instructions (3 / 6 / 12 / 24 bodies) | found |\n|---|---|")
    for workload, name in WORKLOADS.items():
        shares = [shares_of(folder / f"{workload}-{bodies}-cambrian.callgrind") for bodies in BODIES]
        for subject in [subject for subject, _ in SUBJECTS] + [REST]:
            cells = " / ".join(f"{share.get(subject, 0.0):.1f}" for share in shares)
            print(f"| {name}, {subject} | {cells} |")


if __name__ == "__main__":
    main()
