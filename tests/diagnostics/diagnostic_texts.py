# SPDX-License-Identifier: MIT
"""Every text that the language or a preset can complain with is in some test.

Usage: diagnostic_texts.py ROOT
Takes the sentences in the sources' string literals, cuts them at their placeholders, and looks for
each piece in the string literals of the tests. A text that is put together at run time counts by its
pieces.
"""

import ast
import pathlib
import re
import sys

SOURCES = ('src/formula', 'src/scene', 'src/compile')
TESTS = ('tests/formula', 'tests/scene', 'tests/compile', 'tests/cli', 'tests/studio')

TOKEN = re.compile(r'''
    //[^\n]* | /\*.*?\*/ | ^[ ]*\#[^\n]*                 # comments and directives
  | R"(?P<mark>[^(\s]*)\((?P<raw>.*?)\)(?P=mark)"
  | "(?P<plain>(?:[^"\\\n]|\\.)*)"
  | '(?:[^'\\\n]|\\.)+'
''', re.VERBOSE | re.DOTALL | re.MULTILINE)
ESCAPE = re.compile(r'\\(x[0-9A-Fa-f]{1,2}|.)')
PLACEHOLDER = re.compile(r'\{[^{}]*\}')
SENTENCE = re.compile(r"[A-Za-z]{2,}[,;:]? [A-Za-z'\"]")


def unescaped(text):
    plain = {'n': '\n', 't': '\t', 'r': '\r', '0': '\0'}
    return ESCAPE.sub(lambda m: plain.get(m[1], m[1]), text)


def cpp_literals(source):
    """Each literal with its line; those that only blanks and comments separate are one."""
    joined, line, end = None, 0, 0
    for token in TOKEN.finditer(source):
        text = token['raw'] if token['raw'] is not None else token['plain']
        if text is None:
            if token[0].startswith("'") and joined is not None:
                yield line, joined
                joined = None
            elif source[end:token.start()].isspace() and not token[0].startswith('#'):
                end = token.end()
            continue
        if token['plain'] is not None:
            text = unescaped(text)
        between = source[end:token.start()]
        if joined is not None and (not between or between.isspace()):
            joined += text
        else:
            if joined is not None:
                yield line, joined
            joined, line = text, source.count('\n', 0, token.start()) + 1
        end = token.end()
    if joined is not None:
        yield line, joined


def python_literals(source):
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value


def pieces(text):
    """The parts of a format string between its placeholders that say something."""
    whole = text.replace('{{', '\x01').replace('}}', '\x02')
    for piece in PLACEHOLDER.split(whole):
        piece = piece.replace('\x01', '{').replace('\x02', '}')
        if SENTENCE.search(piece):
            yield piece


def tested_texts(root):
    texts = []
    for folder in TESTS:
        for path in sorted((root / folder).rglob('*')):
            if path.suffix in ('.cpp', '.h'):
                texts += (text for _, text in cpp_literals(path.read_text(encoding='utf-8')))
            elif path.suffix == '.py':
                texts += python_literals(path.read_text(encoding='utf-8'))
    # Its reports and signatures are held against the program by a test.
    texts.append((root / 'docs/language.md').read_text(encoding='utf-8'))
    return '\0'.join(texts)


def untested(root):
    tested = tested_texts(root)
    for folder in SOURCES:
        for path in sorted((root / folder).rglob('*.cpp')):
            for line, text in cpp_literals(path.read_text(encoding='utf-8')):
                for piece in pieces(text):
                    if piece not in tested:
                        yield f'{path.relative_to(root)}:{line}: no test has "{piece}"'


def main():
    problems = list(untested(pathlib.Path(sys.argv[1])))
    print('\n'.join(problems) if problems else 'ok')
    return 1 if problems else 0


if __name__ == '__main__':
    sys.exit(main())
