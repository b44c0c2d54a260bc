#!/usr/bin/env python3
"""Counts words that comments, messages, test names and pages should not use, since they are not
terms of the field.

    check_words.py <root of the tree> [--list] [--clean <folder> ...]

Prints the count of each folder that has any; --list prints each place. Fails if a folder named with
--clean, or one below it, has any. Identifiers and includes do not count.
"""
import argparse
import pathlib
import re
import sys

WORDS = re.compile(r'\b(on show|anew|books|lets? go|letting go|whole(?! numbers?\b)|for good|stands?|strikes?|struck|'
                   r'heeds?|heeded|takes? back|taken back|took back)\b', re.I)
LITERAL_OR_COMMENT = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])\'', re.S)


def spoken(path):
    """Yields line numbers and the text that a person reads there."""
    text = path.read_text(encoding='utf-8')
    if path.suffix == '.md':
        yield from enumerate(text.split('\n'), 1)
    elif path.suffix in ('.h', '.cpp'):
        text = re.sub(r'^#include.*$', '', text, flags=re.M)
        for found in LITERAL_OR_COMMENT.finditer(text):
            first = text.count('\n', 0, found.start()) + 1
            yield from enumerate(found[0].split('\n'), first)
    else:
        for number, line in enumerate(text.split('\n'), 1):
            if re.search(r'#|"""|\'|"', line):
                yield number, line
            elif found := re.match(r'\s*def (test_\w+)', line):
                yield number, found[1].replace('_', ' ')


def check_reader():
    for line, count in [('the whole of it', 1), ('wholesale anew', 1), ('Books on show', 2), ('standard whole numbers', 0)]:
        if len(WORDS.findall(line)) != count:
            sys.exit(f'check_words.py misreads {line!r}')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('root', type=pathlib.Path)
    parser.add_argument('--list', action='store_true')
    parser.add_argument('--clean', nargs='*', default=[], metavar='folder')
    options = parser.parse_args()
    check_reader()
    counts, faults, read = {}, [], 0
    for folder in ('src', 'tests', 'assets/help'):
        for path in sorted((options.root / folder).rglob('*')):
            if path.suffix not in ('.h', '.cpp', '.md', '.py', '.sh', '.cmake'):
                continue
            if path.name == 'check_words.py':
                continue
            read += 1
            place = path.relative_to(options.root)
            for number, line in spoken(path):
                for found in WORDS.finditer(line):
                    counts[place.parent] = counts.get(place.parent, 0) + 1
                    if options.list:
                        print(f'{place}:{number}: {found[0]}: {line.strip()}')
                    if any(place.is_relative_to(clean) for clean in options.clean):
                        faults.append(f'{place}:{number}: "{found[0]}"')
    if not read:
        sys.exit(f'nothing to read under {options.root}')
    if not options.list:
        for folder, count in sorted(counts.items()):
            print(f'{count:4} {folder}')
        print(f'{sum(counts.values()):4} in all')
    print('\n'.join(faults))
    sys.exit(1 if faults else 0)


if __name__ == '__main__':
    main()
