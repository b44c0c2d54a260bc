#!/usr/bin/env python3
"""Counts the assertions of some layers per 1000 lines of their sources, and fails outside a range.

    check_asserts.py SRC --least 10 --most 25 LAYER...

Assertions say what must hold in every simulation and of every genome. Too few find no faults, and too
many hide the code.
"""

import argparse
import pathlib
import re
import sys

ASSERTION = re.compile(r"\bCAMBRIAN_(?:TICK_)?ASSERT\(")


def density(layer):
    """Returns the number of assertions, the number of lines, and assertions per 1000 lines."""
    texts = [path.read_text(encoding="utf-8") for path in sorted(layer.rglob("*"))
             if path.suffix in (".h", ".cpp")]
    asserts = sum(len(ASSERTION.findall(text)) for text in texts)
    lines = sum(text.count("\n") for text in texts)
    return asserts, lines, 1000 * asserts / max(lines, 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("src", type=pathlib.Path)
    parser.add_argument("layers", nargs="+")
    parser.add_argument("--least", type=float, required=True)
    parser.add_argument("--most", type=float, required=True)
    options = parser.parse_args()
    failed = False
    for layer in options.layers:
        asserts, lines, share = density(options.src / layer)
        outside = not options.least <= share <= options.most
        failed |= outside
        print(f"{layer}: {asserts} assertions in {lines} lines, {share:.1f} per 1000"
              + (f" (expected {options.least:g} to {options.most:g})" if outside else ""))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
