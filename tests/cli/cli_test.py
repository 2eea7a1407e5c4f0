#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the built program the way a user does: exit statuses, exact messages, files and statistics.

usage: cli_test.py PATH/TO/zeroset [unittest arguments]
"""

import json
import locale
import math
import os
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = ""
PRESETS = Path(__file__).resolve().parents[2] / "presets"
HELP_LINE = "Run with --help for more information.\n"


def run(*arguments, **environment):
    """The finished run of the program; output as text."""
    return subprocess.run(
        [PROGRAM, *arguments], capture_output=True, encoding="utf-8", errors="replace", timeout=120,
        check=False, env={**os.environ, "ZEROSET_PRESETS": str(PRESETS), **environment})


def read_pfm(path):
    """(kind, width, height, rows from the top, each a list of tuples)."""
    data = Path(path).read_bytes()
    kind, size, scale, body = data.split(b"\n", 3)
    assert float(scale) == -1.0, scale
    width, height = map(int, size.split())
    channels = {b"Pf": 1, b"PF": 3}[kind]
    values = struct.unpack(f"<{width * height * channels}f", body)
    pixels = [values[k:k + channels] for k in range(0, len(values), channels)]
    rows = [pixels[j * width:(j + 1) * width] for j in range(height)]
    return kind.decode(), width, height, rows[::-1]


class Folder(unittest.TestCase):
    """A test with an empty folder of its own."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def file(self, name, text):
        path = self.folder / name
        if isinstance(text, bytes):
            path.write_bytes(text)
        else:
            path.write_text(text, encoding="utf-8")
        return str(path)

    def check(self, result, status, stderr):
        self.assertEqual((result.returncode, result.stderr), (status, stderr))
        self.assertEqual(result.stdout, "")


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


class Usage(Folder):
    def check_usage(self, arguments, message):
        self.check(run(*arguments), 2, f"zeroset: error: {message}\n{HELP_LINE}")

    def test_sizes(self):
        for size in ("0x0", "100000x100000", "0x10", "10x40000"):
            self.check_usage(("render", "--formula", "x=0", "--size", size),
                             f"--size: {size} is out of range; width and height go from 1 to 32768")
        for size in ("10", "axb", "10x", "10x10x10", "1e2x10", "10.5x10", "-5x5", ""):
            result = run("render", "--formula", "x=0", "--size", size)
            self.assertEqual(result.returncode, 2, size)

    def test_nothing_to_render(self):
        self.check_usage(("render",), "render: PRESET or --formula is required")

    def test_both_a_preset_and_a_formula(self):
        self.assertEqual(run("render", "sphere", "--formula", "x").returncode, 2)

    def test_unknown_subcommand_and_option(self):
        self.check_usage(("nope",), "The following argument was not expected: nope")
        self.check_usage(("render", "--formula", "x=0", "--nope"),
                         "The following argument was not expected: --nope")

    def test_an_unknown_tracer_lists_the_names(self):
        result = run("render", "--formula", "x=0", "--tracer", "nope")
        self.assertEqual(result.returncode, 2)
        for name in ("nope", "auto", "sphere", "first-order"):
            self.assertIn(name, result.stderr)

    def test_a_region_outside_of_the_picture(self):
        for region in ("15,15,10,10", "-1,0,5,5", "0,0,0,5", "20,0,1,1", "0,0,21,1",
                       "2147483647,0,2147483647,1"):
            result = run("render", "--formula", "x=0", "--size", "20x20", "--region", region)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn(region, result.stderr)

    def test_parameters(self):
        self.check(run("render", "--formula", "x=0", "--set", "nope=1"), 2,
                   "zeroset: error: --set: the formula has no parameter 'nope'; "
                   "it has none besides t\n")
        self.check(run("render", "--formula", "param a = 1\nx=a", "--set", "b=1"), 2,
                   "zeroset: error: --set: the formula has no parameter 'b'; it has a\n")
        for value in ("NaN", "inf", "1,5", "", "0x10", "1 "):
            self.check(run("render", "--formula", "param a = 1\nx=a", "--set", f"a={value}"), 2,
                       f"zeroset: error: --set: '{value}' is not a finite number\n")
            self.check(run("render", "--formula", "x=t", "--set", f"t={value}"), 2,
                       f"zeroset: error: --set: '{value}' is not a finite number\n")
        c = "param c = (-0.2, 0.6, 0.2, 0.2)\njulia(c)"
        for setting, message in (
                ("c=1", "'c' takes 4 numbers, such as c=-0.2,0.6,0.2,0.2, and c.x sets one of them"),
                ("c=1,2,3,4,5",
                 "'c' takes 4 numbers, such as c=-0.2,0.6,0.2,0.2, and c.x sets one of them"),
                ("c=1,2,,4", "'' is not a finite number"),
                ("c.x=", "'' is not a finite number"),
                ("c.q=1", "'c' has the components 'x', 'y', 'z', 'w', not 'q'"),
                ("c.=1", "'c' has the components 'x', 'y', 'z', 'w', not ''"),
                ("d.x=1", "the formula has no parameter 'd.x'; it has c")):
            self.check(run("render", "--formula", c, "--set", setting), 2,
                       f"zeroset: error: --set: {message}\n")
        self.check(run("render", "--formula", "param a = 1\nx=a", "--set", "a.x=2"), 2,
                   "zeroset: error: --set: 'a' is a single value and has no components; "
                   "write a=2\n")
        kinds = 'param s = "round" in ["round", "square"]\nparam cut = on\nx = s + cut'
        for setting, message in (
                ("s=oval", "'s' is one of 'round', 'square', not 'oval'"),
                ("s=squar", "'s' is one of 'round', 'square', not 'squar'; did you mean 'square'?"),
                ("s=2", "'s' is one of 'round', 'square', not '2'"),
                ("cut=yes", "'cut' is on or off, not 'yes'"),
                ("cut=2", "'cut' is on or off, not '2'")):
            self.check(run("render", "--formula", kinds, "--set", setting), 2,
                       f"zeroset: error: --set: {message}\n")
        self.check_usage(("render", "--formula", "x=0", "--set", "a"),
                         "--set: 'a' should be NAME=VALUE")

    def test_numbers_that_are_none(self):
        for option, value in (("--fov", "0"), ("--fov", "180"), ("--fov", "nan"), ("--eye", "1,2"),
                              ("--eye", "1,2,inf"), ("--bounds", "sphere:0"), ("--bounds", "cube:1"),
                              ("--bounds", "sphere:nan"), ("--steps", "0"), ("--steps", "1e3"),
                              ("--lipschitz", "0"), ("--epsilon", "-1"), ("--repeat", "-1"),
                              ("--backend", "vulkan"), ("--shadow", "x")):
            result = run("render", "--formula", "x=0", option, value)
            self.assertEqual(result.returncode, 2, (option, value))
            self.assertIn(option, result.stderr)

    def test_an_eye_on_its_target(self):
        result = run("render", "--formula", "x=0", "--eye", "1,1,1", "--target", "1,1,1")
        self.assertEqual(result.returncode, 2)

    def test_help_and_version(self):
        for arguments in (("--help",), ("render", "--help"), ("check", "--help"), ("emit", "--help")):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn("Usage:", result.stdout)
        result = run("--version")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertRegex(result.stdout, r"^zeroset \d+\.\d+\.\d+\n$")


class Outputs(Folder):
    SMALL = ("render", "--formula", "x^2 + y^2 + z^2 = 1", "--size", "30x20")

    def test_a_missing_folder(self):
        path = str(self.folder / "none" / "a.png")
        self.check(run(*self.SMALL, "-o", path), 1,
                   f"zeroset: error: cannot write '{path}': there is no folder "
                   f"'{self.folder / 'none'}'; create it or choose another place\n")

    def test_a_folder_as_output(self):
        for option in ("-o", "--depth", "--normal", "--stats"):
            self.check(run(*self.SMALL, option, str(self.folder)), 1,
                       f"zeroset: error: cannot write '{self.folder}': it is a folder; "
                       "name a file in it\n")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_nothing_is_written_when_one_output_cannot_be(self):
        run(*self.SMALL, "-o", str(self.folder / "a.png"), "--depth", str(self.folder / "no" / "b.pfm"))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_error_in_the_formula_leaves_an_old_picture(self):
        path = self.file("a.png", "old")
        run("render", "--formula", "x +", "-o", path)
        self.assertEqual(Path(path).read_text(encoding="utf-8"), "old")

    def test_a_full_disk(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is no /dev/full")
        result = run(*self.SMALL, "--depth", "/dev/full")
        self.assertEqual(result.returncode, 1)
        self.assertIn("cannot write '/dev/full'", result.stderr)

    def test_pfm_headers_sizes_and_values(self):
        depth, normal = str(self.folder / "d.pfm"), str(self.folder / "n.pfm")
        result = run(*self.SMALL, "--eye", "0,0,3", "--target", "0,0,0", "--depth", depth, "--normal",
                     normal)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertTrue(Path(depth).read_bytes().startswith(b"Pf\n30 20\n-1"))
        self.assertTrue(Path(normal).read_bytes().startswith(b"PF\n30 20\n-1"))
        _, width, height, depths = read_pfm(depth)
        _, _, _, normals = read_pfm(normal)
        self.assertEqual((width, height), (30, 20))
        self.assertEqual(depths[0][0][0], math.inf)
        self.assertEqual(normals[0][0], (0, 0, 0))
        self.assertAlmostEqual(depths[10][15][0], 2, delta=0.01)
        self.assertAlmostEqual(normals[10][15][2], 1, delta=0.01)

    def test_rows_are_stored_from_the_bottom(self):
        path = str(self.folder / "d.pfm")
        run("render", "--formula", "sphere(1) & y >= 0", "--size", "30x20", "--eye", "0,0,5",
            "--target", "0,0,0", "--depth", path)
        rows = read_pfm(path)[3]
        self.assertLess(rows[7][15][0], math.inf)
        self.assertEqual(rows[12][15][0], math.inf)

    def test_a_region_is_a_crop(self):
        whole, part = str(self.folder / "w.pfm"), str(self.folder / "p.pfm")
        run(*self.SMALL, "--depth", whole)
        run(*self.SMALL, "--region", "7,3,11,13", "--depth", part)
        _, width, height, rows = read_pfm(part)
        self.assertEqual((width, height), (11, 13))
        self.assertEqual(rows, [row[7:18] for row in read_pfm(whole)[3][3:16]])

    def test_png_has_the_size(self):
        path = self.folder / "a.png"
        self.assertEqual(run(*self.SMALL, "-o", str(path)).returncode, 0)
        data = path.read_bytes()
        self.assertTrue(data.startswith(b"\x89PNG\r\n\x1a\n"))
        self.assertEqual(struct.unpack(">II", data[16:24]), (30, 20))

    def test_every_preset_option_of_bounds(self):
        for bounds in ("sphere:1.5", "sphere:0.1,0,0,1.5", "box:1,1,1", "box:0,0,0.1,1,2,3", "none"):
            self.assertEqual(run(*self.SMALL, "--bounds", bounds).returncode, 0, bounds)


class Settings(Folder):
    FORMULA = ('param c = (0, 0.2, 0)\nparam shape = "round" in ["round", "square"]\n'
               'param cut = on\nparam n = 2 integer\n'
               'translate(sphere(0.5), c) & mix(r, max(abs(x), abs(y)), shape) <= n/4 & z <= 1 - cut')

    def depth(self, *settings):
        path = self.folder / "d.pfm"
        result = run("render", "--formula", self.FORMULA, "--size", "24x24", "--depth", str(path),
                     *(word for setting in settings for word in ("--set", setting)))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return path.read_bytes()

    def test_of_several_spellings_are_one(self):
        default = self.depth()
        for spellings in ((("c=0.1,0.3,0",), ("c.x=0.1", "c.y=0.3"), ("c.y=0.3", "c.x=+0.1")),
                          (("shape=square",), ("shape=1",)),
                          (("cut=off",), ("cut=false",), ("cut=0",)),
                          (("n=3",), ("n=2.6",))):
            pictures = {self.depth(*settings) for settings in spellings}
            self.assertEqual(len(pictures), 1, spellings)
            self.assertNotIn(default, pictures, spellings)
        self.assertEqual(self.depth("shape=round", "cut=on", "n=2", "c=0,.2,0"), default)


class Statistics(Folder):
    def stats(self, *arguments, **environment):
        result = run("render", "--formula", "x^2 + y^2 + z^2 = 1", "--size", "40x30", "--stats", "-",
                     *arguments, **environment)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def test_have_all_fields_of_the_contract(self):
        stats = self.stats()
        for name, kind in (("tracer", str), ("backend", str), ("renderer", str), ("width", int),
                           ("height", int), ("evaluations", int)):
            self.assertIsInstance(stats[name], kind, name)
        for name in ("parse", "analyse", "link", "first_frame"):
            self.assertIsInstance(stats["seconds"][name], float)
            self.assertGreaterEqual(stats["seconds"][name], 0)
        self.assertEqual(stats["seconds"]["frames"], [])
        self.assertEqual((stats["width"], stats["height"]), (40, 30))
        self.assertEqual((stats["tracer"], stats["backend"]), ("auto", "osmesa"))
        self.assertIn("llvmpipe", stats["renderer"])

    def test_add_up(self):
        pixels = self.stats()["pixels"]
        self.assertEqual(pixels["hit"] + pixels["miss"] + pixels["unresolved"], 40 * 30)
        self.assertGreater(pixels["hit"], 0)
        self.assertGreater(pixels["miss"], 0)
        self.assertEqual(pixels["unresolved"], 0)
        few = self.stats("--steps", "2")["pixels"]
        self.assertEqual(few["hit"] + few["miss"] + few["unresolved"], 40 * 30)
        self.assertGreater(few["unresolved"], 0)

    def test_are_of_the_region(self):
        stats = self.stats("--region", "5,6,7,8")
        self.assertEqual((stats["width"], stats["height"]), (7, 8))
        self.assertEqual(sum(stats["pixels"].values()), 56)

    def test_count_evaluations(self):
        stats = self.stats()
        self.assertGreaterEqual(stats["evaluations"], stats["pixels"]["hit"])
        self.assertEqual(stats["evaluations"], self.stats()["evaluations"])

    def test_time_each_repeat(self):
        frames = self.stats("--repeat", "2")["seconds"]["frames"]
        self.assertEqual(len(frames), 2)
        self.assertTrue(all(seconds > 0 for seconds in frames))

    def test_in_a_file(self):
        path = self.folder / "s.json"
        result = run("render", "--formula", "x = 0", "--size", "9x9", "--stats", str(path))
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertEqual(json.loads(path.read_text(encoding="utf-8"))["width"], 9)


class EmitAndCheck(Folder):
    FORMULA = "param a = 0.5 in [0, 1]\nx^2 + a*y^2 + z^2 = 1 | sphere(0.5)"

    def test_emit_prints_the_same_twice(self):
        for what in ("ast", "graph", "glsl"):
            first = run("emit", "--formula", self.FORMULA, "--what", what)
            self.assertEqual((first.returncode, first.stderr), (0, ""))
            self.assertGreater(len(first.stdout), 20)
            self.assertEqual(first.stdout, run("emit", "--formula", self.FORMULA, "--what", what).stdout)

    def test_a_value_of_a_parameter_changes_no_program(self):
        one = run("emit", "--formula", self.FORMULA, "--what", "glsl", "--set", "a=0.25")
        two = run("emit", "--formula", self.FORMULA, "--what", "glsl", "--set", "a=0.75")
        self.assertEqual(one.returncode, 0)
        self.assertEqual(one.stdout, two.stdout)

    def test_emit_wants_to_know_what(self):
        self.assertEqual(run("emit", "--formula", "x = 0").returncode, 2)
        self.assertEqual(run("emit", "--formula", "x = 0", "--what", "nope").returncode, 2)

    def test_check_is_silent_on_success(self):
        result = run("check", "--formula", self.FORMULA)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_warnings_go_to_standard_error(self):
        result = run("check", "--formula", "a = 1\nx = 0")
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        self.assertRegex(result.stderr, r"^formula:1:1: warning: .*'a'")

    def test_every_shipped_preset(self):
        for path in sorted(PRESETS.rglob("*.json")):
            result = run("check", str(path))
            self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""), path)


class Locale(Folder):
    def test_a_decimal_comma_changes_nothing(self):
        names = ("de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8")
        for name in names:
            try:
                locale.setlocale(locale.LC_NUMERIC, name)
                break
            except locale.Error:
                continue
        else:
            self.skipTest(f"none of {', '.join(names)} is installed")
        self.addCleanup(locale.setlocale, locale.LC_NUMERIC, "C")
        arguments = ("--formula", "param a = 0.5\nx^2 + 1.5y^2 + a*z^2 = .9", "--set", "a=0.75")
        for what in ("ast", "graph", "glsl"):
            plain = run("emit", *arguments, "--what", what, LC_ALL="C")
            self.assertEqual(plain.returncode, 0, plain.stderr)
            self.assertEqual(plain.stdout, run("emit", *arguments, "--what", what, LC_ALL=name).stdout)
        depths = []
        for k, value in enumerate(("C", name)):
            path = self.folder / f"{k}.pfm"
            result = run("render", *arguments, "--size", "20x20", "--eye", "1.5,1.25,3", "--depth",
                         str(path), LC_ALL=value)
            self.assertEqual(result.returncode, 0, result.stderr)
            depths.append(path.read_bytes())
        self.assertEqual(depths[0], depths[1])


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
