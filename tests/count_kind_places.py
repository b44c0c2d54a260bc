#!/usr/bin/env python3
"""Counts, for each kind that the program registers, the other files in src/ that name it.

A kind is named by its quoted id, by the ids of its channels, by the function that registers it and
by its enumerator, if it has one. Its own file, the header that declares that function, the list
that calls it and comments do not count. With --most, the counts of each sort are limited, so that
they can only fall.
"""

import argparse
import functools
import pathlib
import re
import sys

# For each sort: the files that define its kinds, the pattern that registers one there, and the
# files that list the registrations. Group 1 of the pattern is the id.
SORTS = {
    "sensor": ("sensors/*_sensor.cpp", r'sensors\.add\(\{\.id = "([^"]+)"'),
    "effector": ("effectors/*_effector.cpp", r'effectors\.add\(\{\.id = "([^"]+)"'),
    "organ": ("organs/*_organ.cpp", r'organs\.add\(\s*\{\.id = "([^"]+)"'),
    "goal": ("goals/*.cpp", r'goals\.add\(\{\.id = "([^"]+)"'),
    "selection": ("evolution/selections/*.cpp", r'selections\.add\(\s*\{\.id = "([^"]+)"'),
    "breeding": ("breeding/*.cpp", r'methods\.add\(\{\.id = "([^"]+)"'),
    "mutation": ("breeding/mutations/*.cpp", r'mutations\.add\(\s*\{\s*"([^"]+)"'),
    "function": ("brain/functions/*.cpp",
                 r'\{\.id = "([^"]+)"|functions, "([^"]+)"|\{"([^"]+)", "'),
    "integrator": ("dynamics/**/integrators/*.cpp", r'"([a-z-]+)"'),
    "joint": ("dynamics/joints/*.cpp", r'\.id = "([^"]+)"'),
}
# Ids that are also ordinary words, for example keys in files. Only their registration and channels
# are searched for.
COMMON_WORDS = {"joint", "contact", "effector", "weight", "source", "function", "root", "sum",
                "product", "if", "light", "jumping", "organ", "sound", "scent",
                "energy"}
# Sorts that may have an enumeration, such as kGrafting for "grafting".
ENUMERATED = {"breeding", "selection", "integrator"}
COMMENT = re.compile(r"//.*")
CHANNEL = re.compile(r'\{"([^"]+)", "[^"]+"(?:, \d+)?\}')
REGISTRATION = re.compile(r"^void ((?:add|register)_\w+)\(\w+Registry& ", re.MULTILINE)


def kinds_of(src, sort):
    """Yields (id, own file, names) of each kind of the sort."""
    files, pattern = SORTS[sort]
    for path in sorted(src.glob(files)):
        if path.name.startswith("builtin_"):
            continue
        text = path.read_text()
        found = [next(filter(None, match)) if isinstance(match, tuple) else match
                 for match in re.findall(pattern, text)]
        for kind in dict.fromkeys(found):
            names = {f'"{kind}"'} - {f'"{word}"' for word in COMMON_WORDS}
            if sort in ENUMERATED:
                names.add("k" + "".join(word.capitalize() for word in kind.split("-")))
            if len(found) == 1:
                names |= {rf"{name}(" for name in REGISTRATION.findall(text)}
                if sort == "sensor":
                    names |= {f'"{channel}"' for channel in CHANNEL.findall(text)}
                    names -= {f'"{word}"' for word in COMMON_WORDS}
            yield kind, path, names


def is_named(name, text, path):
    if name.endswith("("):  # a declaration does not count
        return path.suffix == ".cpp" and name in text
    if name.startswith("k"):
        return re.search(rf"\b{name}\b", text) is not None
    return name in text


@functools.cache
def sources(src):
    """Returns (path, text without comments) of all files but the lists."""
    return [(path, COMMENT.sub("", path.read_text())) for path in sorted(src.rglob("*"))
            if path.suffix in (".h", ".cpp") and not path.name.startswith("builtin_")]


def places(src, own, names):
    """Returns the files that name it other than its own file, its declaration and the list."""
    return [path for path, text in sources(src)
            if path != own and any(is_named(name, text, path) for name in names)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("src", type=pathlib.Path)
    parser.add_argument("--most", action="append", default=[], metavar="SORT=COUNT",
                        help="fail if a kind of the sort is named in more files")
    arguments = parser.parse_args()
    limits = dict(limit.split("=") for limit in arguments.most)
    faults = []
    for sort in SORTS:
        kinds = list(kinds_of(arguments.src, sort))
        if not kinds:
            faults.append(f"no {sort} found: the pattern that finds them is out of date")
        for kind, own, names in kinds:
            found = places(arguments.src, own, names)
            where = " ".join(str(path.relative_to(arguments.src)) for path in found)
            print(f"{sort:10} {kind:20} {len(found):2} {where}")
            if len(found) > int(limits.get(sort, len(found))):
                faults.append(f"{sort} {kind}: named in {len(found)} other files, "
                              f"at most {limits[sort]} allowed")
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
