# SPDX-License-Identifier: MIT
"""Tests of diagnostic_texts.py."""

import pathlib
import tempfile
import unittest

import diagnostic_texts


def literals(source):
    return [text for _, text in diagnostic_texts.cpp_literals(source)]


class Literals(unittest.TestCase):
    def test_that_stand_side_by_side_are_one(self):
        self.assertEqual(literals('f("one "\n   "text", "another")'), ['one text', 'another'])
        self.assertEqual(literals('f("one "  // why\n  "text")'), ['one text'])

    def test_are_not_in_comments_directives_and_characters(self):
        self.assertEqual(literals('#include "a.h"\n// "b"\n/* "c" */ \'"\' "d"'), ['d'])

    def test_have_their_escapes_resolved(self):
        self.assertEqual(literals(r'"a \"b\" \\ \n"'), ['a "b" \\ \n'])
        self.assertEqual(literals('R"(a "b" \\n)" R"x()")x"'), ['a "b" \\n)"'])

    def test_know_their_line(self):
        self.assertEqual(list(diagnostic_texts.cpp_literals('\n\n"a";\n"b"')), [(3, 'a'), (4, 'b')])


class Pieces(unittest.TestCase):
    def test_are_between_the_placeholders(self):
        self.assertEqual(list(diagnostic_texts.pieces("the range of '{}' is empty; write {:.3g} {}")),
                         ["the range of '", "' is empty; write "])

    def test_are_sentences_only(self):
        self.assertEqual(list(diagnostic_texts.pieces("{}, {}: f(a) '{}'")), [])


class Untested(unittest.TestCase):
    def find(self, source, test):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in (('src/formula/a.cpp', source), ('tests/formula/a_test.cpp', test),
                               ('docs/language.md', '')):
                (root / name).parent.mkdir(parents=True)
                (root / name).write_text(text, encoding='utf-8')
            return list(diagnostic_texts.untested(root))

    def test_texts_are_found_with_their_place(self):
        source = '\nerror(fmt::format("unknown name \'{}\'", name));'
        self.assertEqual(self.find(source, 'check("x", "unknown name \'y\'");'), [])
        self.assertEqual(self.find(source, 'check("x", "another text");'),
                         ['src/formula/a.cpp:2: no test has "unknown name \'"'])


if __name__ == '__main__':
    unittest.main()
