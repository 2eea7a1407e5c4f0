#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the tests of the command line share: the built program, and tests with a folder of their own.

usage of each test: NAME_test.py PATH/TO/zeroset [unittest arguments]
"""

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


def main():
    """Runs the tests of the script that calls it."""
    global PROGRAM
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main(module="__main__")
