#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`zeroset compare`: judging one picture's depths by another's."""

import json
import math
import struct

from program import Folder, main, run

NAN = math.nan
INF = math.inf


class Compare(Folder):
    def pfm(self, name, values, width=None, channels=1):
        width = width or len(values) // channels
        kind = "Pf" if channels == 1 else "PF"
        head = f"{kind}\n{width} {len(values) // channels // width}\n-1.0\n".encode()
        return self.file(name, head + struct.pack(f"<{len(values)}f", *values))

    def numbers(self, *arguments):
        result = run("compare", *arguments, "--json", "-")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def test_each_number(self):
        # One row: the footprint at depth 1 is 2 tan(45 degrees) = 2, so half of it is 1.
        reference = self.pfm("r.pfm", [1, 1, 1, INF, INF, 1, NAN])
        got = self.pfm("g.pfm", [1.5, 2.5, INF, INF, 3, NAN, 3])
        numbers = self.numbers(reference, got, "--fov", "90")
        self.assertEqual(numbers, {
            "heuristic": False,
            "pixels": {"compared": 6, "wrong": 4, "missed": 2, "phantom": 1, "moved": 1, "no_depth": 1,
                       "fragile": 0, "undecided": 1},
            "depth_error": {"median": 0.5, "percentile_99": 0.5, "largest": 0.5}})

    def test_text(self):
        reference = self.pfm("r.pfm", [1, 1, 1, INF, INF, 1, NAN])
        got = self.pfm("g.pfm", [1.5, 2.5, INF, INF, 3, NAN, 3])
        result = run("compare", reference, got, "--fov", "90")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout, (
            "wrong         4 of 6 pixels (66.7 %)\n"
            "  missed      2\n"
            "  phantom     1\n"
            "  moved       1 by more than half a pixel's footprint in depth\n"
            "no depth      1 of the wrong pixels are NaN or negative\n"
            "not compared  1: 1 undecided, 0 fragile\n"
            "depth error   median 0.5, 99 % 0.5, largest 0.5 (relative, of right hits)\n"))

    def test_the_field_of_view_decides_what_is_moved(self):
        reference, got = self.pfm("r.pfm", [1]), self.pfm("g.pfm", [1.5])
        self.assertEqual(self.numbers(reference, got, "--fov", "90")["pixels"]["moved"], 0)
        self.assertEqual(self.numbers(reference, got)["pixels"]["moved"], 1)

    def test_normals(self):
        reference, got = self.pfm("r.pfm", [1, INF]), self.pfm("g.pfm", [1, INF])
        normals = (self.pfm("rn.pfm", [0, 0, 1, 0, 0, 0], channels=3),
                   self.pfm("gn.pfm", [0, 1, 0, 0, 0, 0], channels=3))
        numbers = self.numbers(reference, got, "--normals", *normals)
        self.assertEqual(numbers["normal_degrees"],
                         {"median": 90, "percentile_99": 90, "largest": 90})
        text = run("compare", reference, got, "--normals", *normals).stdout
        self.assertIn("normal error  median 90, 99 % 90, largest 90 degrees\n", text)

    def test_a_render_is_right_by_itself_and_wrong_by_another(self):
        paths = {}
        for name, radius in (("a", 1), ("b", 0.9)):
            paths[name] = [str(self.folder / f"{name}.{kind}") for kind in ("d.pfm", "n.pfm", "png")]
            run("render", "--formula", f"sphere({radius})", "--size", "40x30", "--depth",
                paths[name][0], "--normal", paths[name][1], "-o", paths[name][2])
        a, b = paths["a"], paths["b"]
        marked = self.folder / "m.png"
        same = self.numbers(a[0], a[0], "--normals", a[1], a[1], "--pictures", a[2], a[2])
        self.assertEqual((same["pixels"]["wrong"], same["pixels"]["compared"]), (0, 1200))
        self.assertEqual(same["depth_error"]["largest"], 0)
        self.assertEqual(same["picture"], {"mean": 0, "largest": 0, "changed": 0, "pixels": 1200})
        other = self.numbers(a[0], b[0], "--pictures", a[2], b[2], "--marked", str(marked))
        self.assertGreater(other["pixels"]["missed"], 20)
        self.assertEqual(other["pixels"]["phantom"], 0)
        self.assertGreater(other["pixels"]["moved"], 100)
        self.assertGreater(other["picture"]["changed"], 20)
        self.assertEqual(struct.unpack(">II", marked.read_bytes()[16:24]), (40, 30))

    def test_a_reference_of_the_oracle(self):
        reference, depth, normal = (str(self.folder / name) for name in ("r", "d.pfm", "n.pfm"))
        scene = ("--formula", "x^2 + y^2 + z^2 = 1", "--size", "40x30")
        run("oracle", *scene, "--reference", reference)
        run("render", *scene, "--depth", depth, "--normal", normal, "--epsilon", "0.001")
        numbers = self.numbers(reference, depth, "--normals", normal)
        self.assertEqual(numbers["pixels"]["wrong"], 0)
        self.assertGreater(numbers["pixels"]["compared"], 1100)
        self.assertLess(numbers["depth_error"]["largest"], 1e-5)
        self.assertLess(numbers["normal_degrees"]["median"], 0.01)
        self.check(run("compare", reference, depth, "--normals", normal, normal), 1,
                   f"zeroset: error: '{reference}' holds normals as well; --normals must name those "
                   "of the other picture alone\n")
        self.check(run("compare", depth, depth, "--normals", normal), 1,
                   f"zeroset: error: '{depth}' holds depths alone; --normals must name the normals "
                   "of both, its own first\n")

    def test_estimates_prove_nothing(self):
        reference, depth = str(self.folder / "r"), str(self.folder / "d.pfm")
        scene = ("--formula", "mandelbulb(8, 3)", "--size", "8x6")
        run("oracle", *scene, "--reference", reference)
        run("render", *scene, "--depth", depth)
        self.assertTrue(self.numbers(reference, depth)["heuristic"])
        self.assertTrue(run("compare", reference, depth).stdout.endswith(
            "\nParts of the reference rest on distance estimates of escape-time sets: they prove "
            "nothing.\n"))

    def test_a_limit_for_scripts(self):
        reference, got = self.pfm("r.pfm", [1, 1]), self.pfm("g.pfm", [INF, 3])
        self.assertEqual(run("compare", reference, got).returncode, 0)
        self.assertEqual(run("compare", reference, got, "--fail-above", "2").returncode, 0)
        self.assertEqual(run("compare", reference, got, "--fail-above", "1").returncode, 1)

    def test_json_in_a_file_beside_the_text(self):
        reference, path = self.pfm("r.pfm", [1]), self.folder / "m.json"
        result = run("compare", reference, reference, "--json", str(path))
        self.assertTrue(result.stdout.startswith("wrong         0 of 1 pixels (0 %)\n"))
        self.assertEqual(json.loads(path.read_text(encoding="utf-8"))["pixels"]["wrong"], 0)

    def test_files_at_fault(self):
        one, two = self.pfm("1.pfm", [1]), self.pfm("2.pfm", [1, 1])
        colour = self.pfm("c.pfm", [0, 0, 1], channels=3)
        text, none = self.file("t.pfm", "text"), str(self.folder / "none.pfm")
        for arguments, message in (
                ((one, two), "the reference has 1x1 pixels, the depth 2x1; compare pictures of one size"),
                ((two, two, "--normals", colour, colour),
                 "the reference's depth has 2x1 pixels, its normal 1x1; both must be of one picture"),
                ((one, text), f"cannot read '{text}': it is not a PFM file"),
                ((one, colour), f"cannot read '{colour}': it is a colour PFM, not a grey one"),
                ((one, one, "--marked", str(self.folder)),
                 f"cannot write '{self.folder}': it is a folder; name a file in it")):
            self.check(run("compare", *arguments), 1, f"zeroset: error: {message}\n")
        for arguments in ((text, one), (none, one), (one, none)):
            self.assertEqual(run("compare", *arguments).returncode, 1)

    def test_pictures_of_two_sizes(self):
        depth = self.pfm("1.pfm", [1])
        a, b = str(self.folder / "a.png"), str(self.folder / "b.png")
        run("render", "--formula", "x=0", "--size", "4x3", "-o", a)
        run("render", "--formula", "x=0", "--size", "3x3", "-o", b)
        self.check(run("compare", depth, depth, "--pictures", a, b), 1,
                   f"zeroset: error: '{a}' has 4x3 pixels, '{b}' 3x3; compare pictures of one size\n")

    def test_wrong_usage(self):
        one = self.pfm("1.pfm", [1])
        for arguments in ((one,), (one, one, "--fov", "0"), (one, one, "--pictures", one),
                          (one, one, "--fail-above", "-1")):
            self.assertEqual(run("compare", *arguments).returncode, 2, arguments)


if __name__ == "__main__":
    main()
