#!/usr/bin/env python3
"""Counts the functions that make one description of a creature from another, and fails above a limit.

    count_converters.py SRC --most 2

A creature that was evaluated is a JudgedIndividual everywhere; structures that have one as a member
describe the same creature with what else they know of it. A function that returns one of these and
takes another is a converter. With many of them, a new fact about creatures gets lost on the way.
Functions that take the JudgedIndividual itself pass it on whole, and those that return a Result run
a trial or read a file; neither are counted.
"""

import argparse
import pathlib
import re
import sys

CORE = "JudgedIndividual"
STRUCTURE = re.compile(r"\b(?:struct|class) (\w+)[^;{()]*\{(.*?)^\s*\};", re.S | re.M)
MEMBER = re.compile(r"^\s+%s \w+(?:\s*=[^;]*|\{[^;]*)?;" % CORE, re.M)
WRAPPERS = r"(?:std::optional<|std::unique_ptr<|std::vector<)?"
FUNCTION = r"^(?:\[\[nodiscard\]\] |inline |static )*%s(?:const )?(%s)>?&? ([\w:]+)\(([^;{]*?)\)"


def sources(folder):
    return [path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*"))
            if path.suffix in (".h", ".cpp")]


def descriptions(texts):
    """Returns the names of the structures that have an evaluated creature as a member, and its own."""
    found = {CORE}
    for text in texts:
        found |= {name for name, body in STRUCTURE.findall(text) if MEMBER.search(body)}
    return found


def converters(texts, kinds):
    names = "|".join(sorted(kinds))
    function = re.compile(FUNCTION % (WRAPPERS, names), re.M)
    argument = re.compile(r"\b(%s)\b" % names)
    found = set()
    for text in texts:
        for result, name, arguments in function.findall(text):
            found |= {(name.split("::")[-1], taken, result) for taken in argument.findall(arguments)
                      if taken not in (CORE, result)}
    return sorted(found)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("src", type=pathlib.Path)
    parser.add_argument("--most", type=int, required=True)
    options = parser.parse_args()
    texts = sources(options.src)
    kinds = descriptions(texts)
    found = converters(texts, kinds)
    for name, taken, result in found:
        print(f"{name}: from {taken} to {result}")
    print(f"{len(found)} converters between {len(kinds)} descriptions: {', '.join(sorted(kinds))}")
    # Without the structures that are known to describe creatures, the count says nothing.
    sys.exit(1 if len(found) > options.most or len(kinds) < 4 else 0)


if __name__ == "__main__":
    main()
