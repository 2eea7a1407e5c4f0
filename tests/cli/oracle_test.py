#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The reference picture of the command line."""

import json
import math
import os
from pathlib import Path

from program import HELP_LINE, Folder, main, read_pfm, run

BALL = ("oracle", "--formula", "x^2 + y^2 + z^2 = 1", "--size", "40x30", "--eye", "0,0,3", "--target",
        "0,0,0")


class Oracle(Folder):
    def setUp(self):
        super().setUp()
        os.environ["XDG_CACHE_HOME"] = str(self.folder / "own")

    def test_says_what_is_proven(self):
        result = run(*BALL, "--stats", "-")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        stats = json.loads(result.stdout)
        self.assertEqual((stats["width"], stats["height"]), (40, 30))
        self.assertGreater(stats["seconds"], 0)
        pixels = stats["pixels"]
        self.assertEqual(pixels["hit"] + pixels["miss"] + pixels["undecided"], 1200)
        self.assertEqual(pixels["undecided"], 0)
        self.assertGreater(pixels["hit"], 300)
        self.assertIs(stats["heuristic"], False)
        self.assertEqual(pixels["estimated"], 0)
        self.assertLessEqual(stats["largest_enclosure"], 1e-9)

    def test_writes_depth_and_normal_of_the_rays_of_the_contract(self):
        depth, normal = str(self.folder / "d.pfm"), str(self.folder / "n.pfm")
        self.check(run(*BALL, "--depth", depth, "--normal", normal), 0, "")
        kind, width, height, rows = read_pfm(depth)
        self.assertEqual((kind, width, height), ("Pf", 40, 30))
        k = math.tan(math.radians(22.5))
        for j, row in enumerate(rows):
            for i, (actual,) in enumerate(row):
                x, y = k * ((2 * i + 1) / 40 - 1) * 40 / 30, k * (1 - (2 * j + 1) / 30)
                cosine = 1 / math.sqrt(1 + x * x + y * y)
                inside = 9 * cosine * cosine - 8
                expected = 3 * cosine - math.sqrt(inside) if inside > 0 else math.inf
                if math.isinf(expected):
                    self.assertEqual(actual, math.inf)
                else:
                    self.assertAlmostEqual(actual / expected, 1, delta=1e-7)
        kind, _, _, rows = read_pfm(normal)
        self.assertEqual(kind, "PF")
        self.assertEqual(rows[0][0], (0, 0, 0))
        self.assertGreater(rows[15][20][2], 0.99)

    def test_writes_pictures_and_a_reference(self):
        names = [str(self.folder / name) for name in ("a.png", "c.png", "r")]
        self.check(run(*BALL, "-o", names[0], "--certificate", names[1], "--reference", names[2]), 0,
                   "")
        for name in names[:2]:
            with open(name, "rb") as file:
                self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
        with open(names[2], "rb") as file:
            self.assertEqual(file.readline(), b"zeroset reference 2 40 30\n")

    def test_keeps_what_was_traced(self):
        names = [str(self.folder / name) for name in "abc"]
        place = {"XDG_CACHE_HOME": str(self.folder / "cache")}
        for name in names[:2]:
            self.check(run(*BALL, "--reference", name, **place), 0, "")
        kept = list((self.folder / "cache" / "zeroset" / "oracle").iterdir())
        self.assertEqual(len(kept), 1)
        kept[0].write_bytes(kept[0].read_bytes()[:-9])
        self.check(run(*BALL, "--reference", names[2], **place), 0, "")
        contents = [Path(name).read_bytes() for name in names]
        self.assertEqual(contents[0], contents[1])
        self.assertEqual(contents[0], contents[2])
        self.assertEqual(kept[0].read_bytes(), contents[0])
        kept[0].unlink()
        self.check(run(*BALL, "--no-cache", **place), 0, "")
        self.assertEqual(list(kept[0].parent.iterdir()), [])

    def test_says_where_nothing_is_proven(self):
        result = run("oracle", "--formula", "mandelbulb(8, 3)", "--size", "8x6", "--stats", "-")
        stats = json.loads(result.stdout)
        self.assertIs(stats["heuristic"], True)
        self.assertEqual(stats["pixels"]["estimated"], 48)

    def test_takes_the_options_of_render(self):
        self.check(run(*BALL, "--tracer", "sphere", "--steps", "9", "--no-shadow", "--no-ao",
                       "--epsilon", "1", "--lipschitz", "2", "--shadow", "3"), 0, "")
        result = run(*BALL, "--region", "0,0,4,3", "--threads", "2", "--stats", "-")
        self.assertEqual(json.loads(result.stdout)["width"], 4)

    def test_tells_faults_by_its_status(self):
        self.assertEqual(run("oracle", "--formula", "sine(x) = 0").returncode, 1)
        self.assertEqual(run("oracle", "no_such_preset").returncode, 1)
        result = run(*BALL, "--threads", "0")
        self.assertEqual(result.returncode, 2)
        self.assertTrue(result.stderr.endswith(HELP_LINE), result.stderr)
        self.assertEqual(run(*BALL, "--region", "0,0,41,3").returncode, 2)
        self.assertEqual(run(*BALL, "-o", str(self.folder / "no" / "a.png")).returncode, 1)


if __name__ == "__main__":
    main()
