#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Wrong usage: exit status 2, and what the message says."""

from program import HELP_LINE, Folder, main, run


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


if __name__ == "__main__":
    main()
