#!/usr/bin/env python3
"""Fails if a comment or a README cites a page, or a numbered section of one, that does not exist.

    check_citations.py <root of the tree>

A page is named by its path from the root, from src/, from tests/ or from the folder of the file that
cites it: "genome/README.md 2" is the section "## 2. ..." of src/genome/README.md. Sections listed
after it ("1 to 3", "2 and 4", "2, 4") are checked as well.
"""
import pathlib
import re
import sys
import tempfile

LITERAL_OR_COMMENT = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)|R"(\w*)\(.*?\)\2"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])\'',
    re.S)
CITATION = re.compile(r'(?<![\w./>-])(?P<page>\w[\w./-]*\.md)\b(?P<sections>`? \d+(?:(?:,| and| to) \d+)*)?')


def comments_of(path):
    text = path.read_text(encoding='utf-8')
    if path.suffix == '.md':
        return text
    if path.suffix in ('.h', '.cpp'):
        return '\n'.join(found['comment'] for found in LITERAL_OR_COMMENT.finditer(text) if found['comment'])
    return '\n'.join(re.findall(r'(?:^|\s)#[^\n]*', text))


def page_of(name, path, root):
    for start in (root, root / 'src', root / 'tests', path.parent):
        if (start / name).is_file():
            return start / name
    return None


def faults_of(path, root):
    place = path.relative_to(root)
    for found in CITATION.finditer(comments_of(path)):
        page = page_of(found['page'], path, root)
        if page is None:
            yield f'{place}: cites {found["page"]}, which is not in the tree'
            continue
        headings = re.findall(r'^#+ (\d+)\. ', page.read_text(encoding='utf-8'), re.M)
        for section in re.findall(r'\d+', found['sections'] or ''):
            if section not in headings:
                yield f'{place}: cites section {section} of {page.relative_to(root)}, which has none'


def sources_of(root):
    for folder in ('src', 'tests'):
        for path in sorted((root / folder).rglob('*')):
            if path.suffix in ('.h', '.cpp', '.md', '.sh', '.cmake') or path.name == 'CMakeLists.txt':
                yield path


def faults_in(root):
    return [fault for path in sources_of(root) for fault in faults_of(path, root)]


def check_checker():
    """Finds each kind of fault in a test tree, so that a parser that misses one cannot pass."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / 'src' / 'low').mkdir(parents=True)
        (root / 'src' / 'low' / 'README.md').write_text('# Low\n\n## 1. One\n\n## 2. Two\n')
        source = root / 'src' / 'low' / 'low.h'
        for text, faults in [('// See low/README.md 1 and 2 (README.md).', 0), ('"gone.md"', 0),
                             ('// gone.md 1', 1), ('/* low/README.md 3 */', 1),
                             ('// low/README.md 1 to 3', 1), ("char c = '\"'; // gone.md", 1)]:
            source.write_text(text + '\n')
            if len(faults_in(root)) != faults:
                sys.exit(f'check_citations.py misjudges {text!r}: {faults_in(root)}')


def main():
    check_checker()
    root = pathlib.Path(sys.argv[1]).resolve()
    faults = faults_in(root)
    count = sum(1 for _ in sources_of(root))
    if not count:
        sys.exit(f'no sources under {root}')
    print('\n'.join(faults) or f'{count} files checked')
    sys.exit(1 if faults else 0)


if __name__ == '__main__':
    main()
