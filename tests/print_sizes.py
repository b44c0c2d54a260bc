#!/usr/bin/env python3
"""Prints the largest classes, files and folders of a tree; nothing fails by its size.

    print_sizes.py <folder> [--most 10]

Members are a class's own data. Functions are those it declares itself, including constructors,
operators and deleted ones. Friends, nested types and inherited members do not count.
"""
import argparse
import collections
import pathlib
import re
import sys

LITERALS_AND_COMMENTS = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])\'',
    re.S)
CLASS = re.compile(r'\b(?:class|struct|union)\s+((?:\w+::)*\w+)(?:\s+final)?(\s*:[^;{(]*)?\s*\{')
SKIPPED = re.compile(r'(friend|using|typedef|static_assert|enum)\b')
PAIRS = {'{': '}', '(': ')', '[': ']'}


def without_literals(text):
    text = re.sub(r'^[ \t]*#.*(?:\\\n.*)*$', '', text, flags=re.M)
    return LITERALS_AND_COMMENTS.sub(lambda found: '""' if found[0][0] in '"R\'' else ' ', text)


def end_of(text, start):
    """Returns the position after the bracket that closes the one at start."""
    close, depth = PAIRS[text[start]], 0
    for i in range(start, len(text)):
        depth += (text[i] == text[start]) - (text[i] == close)
        if depth == 0:
            return i + 1
    raise ValueError('a bracket is not closed: ' + text[start:start + 60])


def text_of(body, start):
    """Returns the text in the brackets that open at start, without inner braces."""
    return re.sub(r'\{[^{}]*\}', '', body[start:end_of(body, start)])


def declarations(body):
    """Returns the declarations in a class's body, each without the content of its braces."""
    words, i = '', 0
    while i < len(body):
        letter = body[i]
        if letter == '{':
            i = end_of(body, i)
            rest = body[i:].lstrip()
            is_function = '(' in without_templates(words).split('=')[0]
            initialized = rest.startswith((';', ',', '{'))
            words += '{}'
            if is_function and not initialized:
                yield words
                words = ''
        elif letter == '(':
            words += text_of(body, i)
            i = end_of(body, i)
        elif letter == ';':
            yield words
            words, i = '', i + 1
        else:
            words, i = words + letter, i + 1


def without_templates(words):
    """Removes template arguments at any depth."""
    before = None
    while before != words:
        before, words = words, re.sub(r'<[^<>]*>', '', words)
    return words


def count(body):
    members = functions = 0
    for words in declarations(body):
        words = re.sub(r'\b(public|private|protected)\s*:(?!:)', ' ', words)
        words = re.sub(r'\[\[.*?\]\]', '', words).strip()
        words = re.sub(r'^template\s*', '', without_templates(re.sub(r'operator\s*[<>=!]+', 'operator_', words)))
        words = re.sub(r'^requires\s*\([^)]*\)\s*', '', words).strip()
        if not words or SKIPPED.match(words):
            continue
        if re.match(r'(class|struct|union)\b[^(]*(\{\})?$', words):
            named_member = re.search(r'\{\}\s*\w+', words)
            members += 1 if named_member else 0
            continue
        if '(' in re.split(r'[={]', words.replace('operator=', 'operator_'))[0]:
            functions += 1
        else:
            flat = re.sub(r'\{\}', '', words)
            while re.search(r'\([^()]*\)', flat):
                flat = re.sub(r'\([^()]*\)', '', flat)
            members += 1 + flat.count(',')
    return members, functions


def classes_of(path):
    text = without_literals(path.read_text(encoding='utf-8'))
    for found in CLASS.finditer(text):
        if re.search(r'enum\s*$', text[:found.start()]):
            continue
        start = found.end() - 1
        yield (found[1], *count(text[start + 1:end_of(text, start) - 1]))


def check_counter():
    """Counts a class with known figures, so that a parser that misses something cannot pass."""
    body = '''
public:
    explicit A(int x) : x_(x), y_{1} {}
    ~A();
    A& operator=(const A&) = delete;
    bool operator<(const A& other) const { return x_ < other.x_; }
    template <class T>
    void run(std::function<void(int)> work = {});
    static Result<std::map<int, std::pair<int, int>>> make();
    friend bool operator==(const A&, const A&) = default;
private:
    struct Inner { int inside; void hidden(); };
    using Value = int;
    std::function<void(int)> call_;
    int x_ = 0, y_ = f(1, 2);
    std::array<char, 64> name_{};
    bool (*ask_)(int) = nullptr;
    A& other_;
'''
    figures = count(without_literals(body))
    # A pointer to a function counts as a function, since it is declared like one.
    if figures != (5, 7):
        sys.exit(f'print_sizes.py miscounts: {figures}')


def print_largest(title, rows, most):
    print(title)
    for figures, name in sorted(rows, reverse=True)[:most]:
        print('  ' + ' '.join(f'{figure:5}' for figure in figures) + f'  {name}')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('folder', type=pathlib.Path)
    parser.add_argument('--most', type=int, default=10)
    options = parser.parse_args()
    check_counter()
    sources = sorted(p for p in options.folder.rglob('*') if p.suffix in ('.h', '.cpp'))
    if not sources:
        sys.exit(f'no sources under {options.folder}')
    relative = {path: path.relative_to(options.folder) for path in sources}
    classes = [((functions, members), f'{name} ({relative[path]})')
               for path in sources for name, members, functions in classes_of(path)]
    files = [((len(path.read_text(encoding='utf-8').splitlines()),), relative[path]) for path in sources]
    folders = collections.Counter(relative[path].parent for path in sources)
    print_largest('functions and members of classes', classes, options.most)
    print_largest('lines of files', files, options.most)
    print_largest('files in folders', [((n,), folder) for folder, n in folders.items()], options.most)
    print(f'{sum(lines for (lines,), _ in files)} lines in {len(files)} files')


if __name__ == '__main__':
    main()
