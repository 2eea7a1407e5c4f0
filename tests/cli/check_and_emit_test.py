#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What check and emit print."""

from program import PRESETS, Folder, main, run


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


if __name__ == "__main__":
    main()
