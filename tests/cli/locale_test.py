#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A locale with a decimal comma changes nothing."""

import locale

from program import Folder, main, run


class Locale(Folder):
    def test_a_decimal_comma_changes_nothing(self):
        names = ("de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8")
        for name in names:
            try:
                locale.setlocale(locale.LC_NUMERIC, name)
                break
            except locale.Error:
                continue
        else:
            self.skipTest(f"none of {', '.join(names)} is installed")
        self.addCleanup(locale.setlocale, locale.LC_NUMERIC, "C")
        arguments = ("--formula", "param a = 0.5\nx^2 + 1.5y^2 + a*z^2 = .9", "--set", "a=0.75")
        for what in ("ast", "graph", "glsl"):
            plain = run("emit", *arguments, "--what", what, LC_ALL="C")
            self.assertEqual(plain.returncode, 0, plain.stderr)
            self.assertEqual(plain.stdout, run("emit", *arguments, "--what", what, LC_ALL=name).stdout)
        depths = []
        for k, value in enumerate(("C", name)):
            path = self.folder / f"{k}.pfm"
            result = run("render", *arguments, "--size", "20x20", "--eye", "1.5,1.25,3", "--depth",
                         str(path), LC_ALL=value)
            self.assertEqual(result.returncode, 0, result.stderr)
            depths.append(path.read_bytes())
        self.assertEqual(depths[0], depths[1])


if __name__ == "__main__":
    main()
