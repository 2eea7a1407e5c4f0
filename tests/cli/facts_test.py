#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What is known about a scene, as text and as JSON, and warnings with a proof."""

import json

from program import PRESETS, Folder, main, run


class Facts(Folder):
    def test_of_a_sphere_as_text(self):
        result = run("check", "--facts", "--formula", "param a = 1\nx^2 + y^2 + z^2 = a")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        lines = result.stdout.splitlines()
        self.assertEqual(lines[0], "scene: sheet")
        self.assertEqual(lines[1:3], ["  degree      2", "  smoothness  smooth, defined everywhere"])
        self.assertRegex(lines[3], r"^  distance    no; changes by at most 4(\.\d+)? a unit$")
        self.assertRegex(lines[4], r"^  extent      \[-1(\.00\d)?, 1(\.00\d)?\] x .*, nothing outside$")
        self.assertEqual(lines[5], "  depends on  x, y, z, a")
        self.assertRegex(lines[6], r"^  operations  \d+ a point, \d+ a frame$")
        self.assertRegex(lines[7], r"^steps: certified by a bound of the second derivative \(2(\.\d+)?\)$")
        self.assertEqual(len(lines), 8)

    def test_of_each_object(self):
        result = run("check", "--facts", "--formula", "sphere(1) | x <= 0")
        self.assertEqual([line for line in result.stdout.splitlines() if line[0] != " "],
                         ["scene of 2 objects: solid", "object 1: solid", "object 2: solid", "steps:"])
        self.assertRegex(result.stdout, "\n  object 1    certified by the distance\n  object 2    certified")

    def test_as_json(self):
        result = run("check", "--json", "--formula", "param a = 1\nsphere(a) | x*t = 0")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        facts = json.loads(result.stdout)
        self.assertEqual([facts["scene"]["kind"], len(facts["objects"])], ["sheet", 2])
        sphere, sheet = facts["objects"]
        self.assertEqual((sphere["kind"], sphere["metric"], sphere["degree"], sphere["depends"]),
                         ("solid", "exact", None, ["x", "y", "z", "a"]))
        self.assertEqual(sphere["extent"]["reach"], "bounded")
        for low, high in zip(sphere["extent"]["low"], sphere["extent"]["high"]):
            self.assertAlmostEqual(low, -1, delta=0.01)
            self.assertAlmostEqual(high, 1, delta=0.01)
        self.assertEqual((sheet["kind"], sheet["degree"], sheet["depends"]), ("sheet", 1, ["x", "t"]))
        self.assertEqual(sheet["smoothness"], "smooth")
        self.assertEqual(facts["scene"]["smoothness"], "piecewise")

    def test_are_the_same_twice(self):
        arguments = ("check", "--json", str(PRESETS / "fractals" / "julia_default.json"))
        self.assertEqual(run(*arguments).stdout, run(*arguments).stdout)

    def test_of_every_shipped_preset(self):
        for path in sorted(PRESETS.rglob("*.json")):
            result = run("check", "--json", str(path))
            self.assertEqual((result.returncode, result.stderr), (0, ""), path)
            self.assertIsNotNone(json.loads(result.stdout)["scene"]["extent"], path)


class ProvenWarnings(Folder):
    TEXT = ("formula:1:1: warning: no part of the solid is in the bounds, the ball of radius 2 about "
            "the origin; change the bounds\ntranslate(sphere(1), (5, 0, 0))\n"
            "^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~\n")

    def test_are_no_errors(self):
        self.check(run("check", "--formula", "translate(sphere(1), (5, 0, 0))"), 0, self.TEXT)

    def test_come_before_a_picture_too(self):
        self.check(run("render", "--formula", "translate(sphere(1), (5, 0, 0))", "--size", "9x9"), 0,
                   self.TEXT)

    def test_are_about_the_bounds_and_values_that_are_drawn(self):
        self.check(run("render", "--formula", "translate(sphere(1), (5, 0, 0))", "--size", "9x9",
                       "--bounds", "sphere:9"), 0, "")
        result = run("render", "--formula", "param d = 0\nx = d", "--size", "9x9", "--set", "d=7")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"^formula:2:1: warning: no part of the surface is in the bounds")

    def test_have_their_place_in_a_preset(self):
        path = self.file("far.json", '{"zeroset": 1,\n "formula": ["a = 5", "x = a"]}\n')
        result = run("check", path)
        self.assertEqual(result.returncode, 0)
        self.assertTrue(result.stderr.startswith(f"{path}:2:24: warning: "), result.stderr)


if __name__ == "__main__":
    main()
