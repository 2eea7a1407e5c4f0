#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pictures and other files that a render writes."""

import math
import os
import struct
from pathlib import Path

from program import Folder, main, read_pfm, run


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


if __name__ == "__main__":
    main()
