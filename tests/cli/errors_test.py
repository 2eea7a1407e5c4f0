#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Errors in formulas and presets: exact messages and places."""

import json

from program import Folder, main, run


class FormulaErrors(Folder):
    def test_an_unfinished_formula(self):
        self.check(run("render", "--formula", "x +"), 1,
                   "formula:1:4: error: expected an expression after '+'\nx +\n   ^\n")

    def test_an_unknown_name_as_in_the_contract(self):
        self.check(run("check", "--formula", "x + y + sine(z) = 0"), 1,
                   "formula:1:9: error: unknown name 'sine'; did you mean 'sin'?\n"
                   "x + y + sine(z) = 0\n        ^~~~\n")

    def test_an_empty_formula(self):
        for text in ("", "   ", "# nothing\n"):
            result = run("render", "--formula", text)
            self.assertEqual(result.returncode, 1)
            self.assertRegex(result.stderr, r"^formula:\d+:\d+: error: the formula is empty; ")

    def test_all_errors_of_one_run(self):
        result = run("check", "--formula", "sine(x) + cosine(y) + foo = 0")
        self.assertEqual(result.returncode, 1)
        places = [line.split(" error")[0] for line in result.stderr.splitlines() if "error:" in line]
        self.assertEqual(places, ["formula:1:1:", "formula:1:11:", "formula:1:23:"])

    def test_ten_thousand_brackets(self):
        text = "(" * 10000 + "x" + ")" * 10000 + " = 0"
        result = run("render", "--formula", text)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"^formula:1:\d+: error: .*(nested|brackets|deep)")
        self.assertLess(len(result.stderr), 2000)

    def test_a_formula_of_a_megabyte(self):
        text = " + ".join(["x"] * 260000) + " = 0"
        path = self.file("long.json", json.dumps({"zeroset": 1, "formula": text}))
        result = run("check", path)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"error: .*(long|bytes)")
        self.assertLess(len(result.stderr), 2000)


class PresetErrors(Folder):
    def test_a_missing_preset(self):
        result = run("render", "no_such_preset")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"^zeroset: error: there is no preset 'no_such_preset'")

    def test_a_misspelt_preset_gets_a_suggestion(self):
        self.assertIn("did you mean", run("render", "spheer").stderr)

    def test_a_directory(self):
        self.check(run("render", str(self.folder)), 1,
                   f"zeroset: error: '{self.folder}' is a directory, not a preset; "
                   "name a .json file in it\n")

    def test_a_truncated_preset_with_its_place(self):
        path = self.file("cut.json", '{\n  "zeroset": 1,\n  "formula": "x = 0"')
        result = run("render", path)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, rf"^{path}:3:\d+: error: ")

    def test_nan_in_a_preset_with_its_place(self):
        path = self.file("nan.json", '{\n  "zeroset": 1,\n  "formula": "x = 0",\n'
                                     '  "bounds": {"sphere": NaN}\n}\n')
        result = run("render", path)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, rf"^{path}:4:24: error: ")

    def test_all_errors_of_a_preset(self):
        path = self.file("two.json", '{"zeroset": 1, "formula": "x = 0",\n'
                                     ' "bounds": {"sphere": -1},\n "camera": {"fov": "wide"}}\n')
        result = run("render", path)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, rf"(?m)^{path}:2:\d+: error: ")
        self.assertRegex(result.stderr, rf"(?m)^{path}:3:\d+: error: ")

    def test_the_places_of_values_that_do_not_suit_the_formula(self):
        path = self.file("values.json", '{"zeroset": 1, "formula": "param size = 1\\nx = size",\n'
                                        ' "parameters": {"size": [1, 2],\n  "sise": 1}}\n')
        self.check(run("check", path), 1,
                   f"{path}:2:25: error: 'parameters.size' must be a number, not a list of 2\n"
                   ' "parameters": {"size": [1, 2],\n                        ^~~~~~\n'
                   f"{path}:3:3: warning: unknown parameter 'sise' is ignored; "
                   "did you mean 'size'?\n"
                   '  "sise": 1}}\n  ^~~~~~\n')

    def test_the_place_of_a_formula_error_inside_the_file(self):
        lines = ['{', '  "zeroset": 1,', '  "formula": [',
                 r'    "param a = 1 in [0, 2] \"size \"",', '    "x + a*sine(y) = 0"', '  ]', '}']
        path = self.file("escaped.json", "\n".join(lines) + "\n")
        self.check(run("check", path), 1,
                   f"{path}:5:12: error: unknown name 'sine'; did you mean 'sin'?\n"
                   '    "x + a*sine(y) = 0"\n           ^~~~\n')

    def test_the_place_behind_escapes(self):
        lines = ['{', '  "zeroset": 1,',
                 r'  "formula": "param a = 1 \"b\" \ny = sine(a*x)"', '}']
        path = self.file("escaped.json", "\n".join(lines) + "\n")
        column = lines[2].index("sine") + 1
        result = run("check", path)
        self.assertEqual(result.returncode, 1)
        self.assertTrue(result.stderr.startswith(f"{path}:3:{column}: error: unknown name 'sine'"),
                        result.stderr)

    def test_broken_utf8(self):
        path = self.file("latin.json", b'{"zeroset": 1, "title": "\xe9", "formula": "x = 0"}')
        result = run("check", path)
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"{path}:1:", result.stderr)


if __name__ == "__main__":
    main()
