"""Checks that no two headers of src define types of the same name in one namespace. A program in which
two layers do is not valid (one definition rule), although compilers do not notice it."""

import pathlib
import re
import sys

NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.MULTILINE)
TYPE = re.compile(r"^(?:struct|class|enum class) (\w+)(?: final)?(?: :[^;{]*)? *\{", re.MULTILINE)


def places_of_types(folder):
    places = {}
    for header in sorted(folder.rglob("*.h")):
        text = header.read_text()
        namespace = NAMESPACE.search(text)
        for name in TYPE.findall(text):
            whole = f"{namespace[1]}::{name}" if namespace else name
            places.setdefault(whole, []).append(header.relative_to(folder))
    return places


def main():
    places = places_of_types(pathlib.Path(sys.argv[1]))
    if not places:
        sys.exit(f"{sys.argv[1]}: no header defines a type")
    faults = [f"{name}: {', '.join(map(str, where))}"
              for name, where in sorted(places.items()) if len(where) > 1]
    sys.exit("\n".join(faults) or 0)


main()
