#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Parameters and settings from the command line."""

from program import Folder, main, run


class Settings(Folder):
    FORMULA = ('param c = (0, 0.2, 0)\nparam shape = "round" in ["round", "square"]\n'
               'param cut = on\nparam n = 2 integer\n'
               'translate(sphere(0.5), c) & mix(r, max(abs(x), abs(y)), shape) <= n/4 & z <= 1 - cut')

    def depth(self, *settings):
        path = self.folder / "d.pfm"
        result = run("render", "--formula", self.FORMULA, "--size", "24x24", "--depth", str(path),
                     *(word for setting in settings for word in ("--set", setting)))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return path.read_bytes()

    def test_of_several_spellings_are_one(self):
        default = self.depth()
        for spellings in ((("c=0.1,0.3,0",), ("c.x=0.1", "c.y=0.3"), ("c.y=0.3", "c.x=+0.1")),
                          (("shape=square",), ("shape=1",)),
                          (("cut=off",), ("cut=false",), ("cut=0",)),
                          (("n=3",), ("n=2.6",))):
            pictures = {self.depth(*settings) for settings in spellings}
            self.assertEqual(len(pictures), 1, spellings)
            self.assertNotIn(default, pictures, spellings)
        self.assertEqual(self.depth("shape=round", "cut=on", "n=2", "c=0,.2,0"), default)


if __name__ == "__main__":
    main()
