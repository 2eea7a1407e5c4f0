#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The statistics of a render."""

import json

from program import Folder, main, run


class Statistics(Folder):
    def stats(self, *arguments, formula="x^2 + y^2 + z^2 = 1", **environment):
        result = run("render", "--formula", formula, "--size", "40x30", "--stats", "-",
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

    def test_say_which_precision_and_why(self):
        stats = self.stats()
        self.assertEqual(stats["precision"], "single")
        self.assertIn("of a pixel", stats["precision_reason"])
        self.assertEqual(self.stats("--precision", "double")["precision"], "double")
        near = self.stats("--target", "0,0,1", "--eye", "0,0.00001,1.00003")
        self.assertEqual(near["precision"], "recentred")
        single = self.stats("--target", "0,0,1", "--eye", "0,0.00001,1.00003", "--precision", "single")
        self.assertEqual((single["precision"], single["precision_reason"]), ("single", "as chosen"))

    def test_add_up(self):
        pixels = self.stats()["pixels"]
        self.assertEqual(pixels["hit"] + pixels["miss"] + pixels["unresolved"], 40 * 30)
        self.assertGreater(pixels["hit"], 0)
        self.assertGreater(pixels["miss"], 0)
        self.assertEqual(pixels["unresolved"], 0)
        few = self.stats("--steps", "1")["pixels"]
        self.assertEqual(few["hit"] + few["miss"] + few["unresolved"], 40 * 30)
        self.assertGreater(few["unresolved"], 0)

    def test_are_of_the_region(self):
        stats = self.stats("--region", "5,6,7,8")
        self.assertEqual((stats["width"], stats["height"]), (7, 8))
        self.assertEqual(sum(stats["pixels"][name] for name in ("hit", "miss", "unresolved")), 56)

    def test_say_what_is_proven(self):
        stats = self.stats()
        pixels = stats["pixels"]
        self.assertEqual(pixels["proven_hit"] + pixels["hit_within_rounding"], pixels["hit"])
        self.assertEqual(pixels["proven_miss"], pixels["miss"])
        self.assertGreater(pixels["proven_hit"], 0.9 * pixels["hit"])
        self.assertEqual(stats["steps"]["summary"], "certified")
        self.assertRegex(stats["steps"]["by"][0]["by"],
                         r"^certified by a bound of the second derivative \(2\.?\d*\)$")
        # Steps that are longer than the proof allows.
        for arguments in (["--lipschitz", "0.5"], ["--tracer", "first-order"]):
            pixels = self.stats(*arguments)["pixels"]
            self.assertEqual(pixels["proven_hit"], 0)
            self.assertGreater(pixels["heuristic_hit"], 0)
        self.assertEqual(self.stats("--lipschitz", "2")["pixels"]["heuristic_hit"], 0)

    def test_say_why_something_is_not_proven(self):
        for formula, reason in (("1/z = x", "a pole or the edge of a domain"),
                                ("floor(z*y) + 0.5 = x", "a jump"),
                                ("mandelbulb(8, 2)", "an estimate of an iteration")):
            result = run("render", "--formula", formula, "--size", "8x6", "--stats", "-")
            stats = json.loads(result.stdout)
            self.assertRegex(stats["steps"]["summary"],
                             "^heuristic: " + reason + r"( in \d+ of \d+ bricks)?$")
            self.assertFalse(stats["steps"]["by"][0]["certified"])
            pixels = stats["pixels"]
            # Most rays go by bricks in which there is no pole and no jump.
            self.assertGreater(pixels["heuristic_hit"] + pixels["heuristic_miss"], 0)
            if formula.startswith("mandelbulb"):
                self.assertEqual(pixels["heuristic_hit"], pixels["hit"])
                self.assertGreater(pixels["hit"], 0)

    def test_count_bricks(self):
        bricks = self.stats(formula="exp(x^2 + y^2 + z^2) = 2 + x")["bricks"]
        self.assertEqual(bricks["count"], bricks["side"]**3 * bricks["grids"])
        self.assertGreater(bricks["empty"], bricks["count"] / 2)
        self.assertEqual(bricks["empty"] + bricks["certified"], bricks["count"])
        self.assertGreater(bricks["seconds"], 0)
        self.assertNotIn("bricks", self.stats(formula="sphere(1)"))

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


if __name__ == "__main__":
    main()
