"""Joins the sources of a build into a few large ones, for tools that read each source's headers again.

    python3 tests/tidy_units.py BUILD COUNT

Reads BUILD/compile_commands.json and writes BUILD/units: a source for each of about COUNT equally large
parts of the program, which includes all sources of its part, and a
compile_commands.json for these. Sources share a unit only if their compiler options are the same, apart
from definitions and folders of headers. Sources that include a header of SEARCHED have units of their
own: for each function of such a header a check searches all of the unit.
"""

import json
import os
import pathlib
import re
import shlex
import sys

WITH_VALUE = {"-isystem", "-include"}
SEARCHED = ("<CLI/CLI.hpp>",)  # by performance-unnecessary-value-param
SHARED = ("-D", "-I", "-isystem")  # options that sources of one unit may have more of than others


def options_of(command):
    """Returns the compiler and the options of a command, without its source and its output."""
    words = iter(shlex.split(command["command"]))
    options = [(next(words),)]
    for word in words:
        if word == "-o":
            next(words)
        elif word in WITH_VALUE:
            options.append((word, next(words)))
        elif word != "-c" and not word.endswith(os.path.basename(command["file"])):
            options.append((word,))
    return options


def text_of(source):
    """Returns the text of a source and of the sources that it includes, if it is a list of such."""
    text = pathlib.Path(source).read_text(encoding="utf-8")
    return text + "".join(map(text_of, re.findall(r'#include "(/[^"]+\.cpp)"', text)))


class Unit:
    def __init__(self, options, text):
        self.kind = (*(option for option in options if not option[0].startswith(SHARED)),
                     *(header for header in SEARCHED if header in text))
        self.options = []
        self.sources = []
        self.lines = 0

    def add(self, source, lines, options):
        self.sources.append(source)
        self.lines += lines
        self.options += [option for option in options if option not in self.options]


def units_of(commands, count):
    texts = {command["file"]: text_of(command["file"]) for command in commands}
    lines = {source: text.count("\n") for source, text in texts.items()}
    most = sum(lines.values()) / count
    units = []
    for command in commands:
        source, options = command["file"], options_of(command)
        new = Unit(options, texts[source])
        fitting = [unit for unit in units
                   if unit.kind == new.kind and unit.lines + lines[source] / 2 < most]
        if not fitting:
            units.append(new)
        (fitting or [new])[-1].add(source, lines[source], options)
    return sorted(units, key=lambda unit: -unit.lines)


def main():
    build, count = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2])
    commands = [command for command
                in json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
                if "/src/" in command["file"]]
    folder = build / "units"
    folder.mkdir(exist_ok=True)
    entries = []
    for i, unit in enumerate(units_of(commands, count)):
        language = pathlib.Path(unit.sources[0]).suffix
        joined = folder / f"unit_{i}{language}"
        joined.write_text("".join(f'#include "{source}"\n' for source in unit.sources), encoding="utf-8")
        words = [word for option in unit.options for word in option]
        entries.append({"directory": str(build), "file": str(joined),
                        "arguments": [*words, "-Wno-everything", "-c", str(joined)]})
    (folder / "compile_commands.json").write_text(json.dumps(entries, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
