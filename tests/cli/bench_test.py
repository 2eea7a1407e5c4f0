#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`zeroset bench`: a tiny run from end to end, and what it refuses."""

from program import HELP_LINE, Folder, main, run

TINY = ("--size", "32x24", "--reference-size", "24x18", "--rounds", "2", "--tracers", "auto,sphere", "--sweep", "lipschitz=2")


class Bench(Folder):
    def test_a_tiny_run_prints_a_table_of_each_preset(self):
        result = run("bench", "torus", "julia_default", *TINY)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("32x24 pixels, 2 rounds", result.stdout)
        first, second = result.stdout.index("surfaces/torus"), result.stdout.index("fractals/julia")
        self.assertLess(first, second)
        for tracer in ("auto", "sphere"):
            rows = [line for line in result.stdout.splitlines() if line.startswith(tracer + " ")]
            self.assertEqual(len(rows), 4, tracer)
            self.assertEqual(sum("lipschitz 2" in row for row in rows), 2)

    def test_what_is_refused(self):
        for arguments, message in (
                (("--size", "0x4"),
                 "--size: 0x4 is out of range; width and height go from 1 to 32768"),
                (("--sweep", "speed=1"),
                 "--sweep: 'speed=1' should be lipschitz=, steps= or epsilon= and values, such as "
                 "lipschitz=0.5,1,2")):
            self.check(run("bench", "torus", *arguments), 2,
                       f"zeroset: error: {message}\n{HELP_LINE}")
        for arguments in (("--tracers", "nope"), ("--rounds", "0"), ("--backend", "vulkan")):
            result = run("bench", "torus", *arguments)
            self.assertEqual(result.returncode, 2)
            self.assertIn(arguments[0], result.stderr)
        result = run("bench", "tours")
        self.assertEqual(result.returncode, 1)
        self.assertIn("torus", result.stderr)
        bad = self.file("bad.json", '{"zeroset": 1, "formula": "sine(x) = 0"}')
        result = run("bench", bad, *TINY)
        self.assertEqual(result.returncode, 1)
        self.assertIn(bad, result.stderr)


if __name__ == "__main__":
    main()
