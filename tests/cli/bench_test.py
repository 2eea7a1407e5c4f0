#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`zeroset bench`: a tiny run from end to end, and what it refuses."""

import csv
import json
from pathlib import Path

from program import HELP_LINE, Folder, main, run

TINY = ("--size", "32x24", "--reference-size", "24x18", "--rounds", "2", "--tracers", "auto,sphere", "--sweep", "lipschitz=2")


class Bench(Folder):
    def bench(self, *arguments):
        return run("bench", *arguments, XDG_CACHE_HOME=str(self.folder / "cache"))

    def test_a_tiny_run_prints_a_table_of_each_preset(self):
        result = self.bench( "torus", "julia_default", *TINY)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("32x24 pixels, 2 rounds", result.stdout)
        first, second = result.stdout.index("surfaces/torus"), result.stdout.index("fractals/julia")
        self.assertLess(first, second)
        self.assertIn("Geometric means", result.stdout)
        for tracer in ("auto", "sphere"):
            rows = [line for line in result.stdout.splitlines() if line.startswith(tracer + " ")]
            self.assertEqual(len(rows), 4, tracer)
            self.assertEqual(sum("lipschitz 2" in row for row in rows), 2)

    def test_all_outputs_and_a_baseline(self):
        docs = self.folder / "docs"
        docs.mkdir()
        names = {name: str(self.folder / f"out.{name}") for name in ("csv", "json", "html")}
        outputs = [part for name, path in names.items() for part in (f"--{name}", path)]
        result = self.bench( "torus", *TINY, *outputs, "--docs", str(docs))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        rows = list(csv.DictReader(Path(names["csv"]).read_text().splitlines()))
        report = json.loads(Path(names["json"]).read_text())
        entries = report["presets"][0]["entries"]
        self.assertEqual([row["tracer"] for row in rows], [entry["tracer"] for entry in entries])
        for entry in entries:
            self.assertEqual(len(entry["seconds"]), 2)
            self.assertEqual(sum(entry["pixels"].values()), 32 * 24)
        self.assertEqual(entries[0]["errors"]["missed"], 0)
        page = Path(names["html"]).read_text()
        self.assertIn("<svg", page)
        self.assertNotIn("http", page)
        self.assertIn("surfaces/torus", (docs / "performance.md").read_text())
        self.assertIn("surfaces/torus", (docs / "accuracy.md").read_text())

        again = self.bench( "torus", *TINY, "--baseline", names["json"])
        self.assertEqual((again.returncode, again.stderr), (0, ""))
        self.assertIn(f"Since {names['json']}:", again.stdout)
        self.assertRegex(again.stdout, r"of \d+ configurations are the same")
        # As if everything had been a hundred times as fast.
        for entry in entries:
            entry["seconds"] = [seconds / 100 for seconds in entry["seconds"]]
        old = self.file("old.json", json.dumps(report))
        worse = self.bench( "torus", *TINY, "--baseline", old, "--fail-on-regression")
        self.assertEqual((worse.returncode, worse.stderr), (1, ""))
        self.assertIn("slower", worse.stdout)

    def test_what_is_refused(self):
        for arguments, message in (
                (("--size", "0x4"),
                 "--size: 0x4 is out of range; width and height go from 1 to 32768"),
                (("--sweep", "speed=1"),
                 "--sweep: 'speed=1' should be lipschitz=, steps= or epsilon= and values, such as "
                 "lipschitz=0.5,1,2")):
            self.check(self.bench( "torus", *arguments), 2,
                       f"zeroset: error: {message}\n{HELP_LINE}")
        for arguments in (("--tracers", "nope"), ("--rounds", "0"), ("--backend", "vulkan")):
            result = self.bench( "torus", *arguments)
            self.assertEqual(result.returncode, 2)
            self.assertIn(arguments[0], result.stderr)
        result = self.bench( "tours")
        self.assertEqual(result.returncode, 1)
        self.assertIn("torus", result.stderr)
        result = self.bench( "torus", "--json", str(self.folder / "no" / "a.json"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("there is no folder", result.stderr)
        result = self.bench( "torus", "--baseline", self.file("old.json", "{}"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("is no report; make one with 'zeroset bench --json'", result.stderr)
        bad = self.file("bad.json", '{"zeroset": 1, "formula": "sine(x) = 0"}')
        result = self.bench( bad, *TINY)
        self.assertEqual(result.returncode, 1)
        self.assertIn(bad, result.stderr)


if __name__ == "__main__":
    main()
