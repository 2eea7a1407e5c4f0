#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the fuzzer for a time, starting from all formulas of the repository.

Texts that break a promise are left beside the fuzzer, in findings/; new texts that reach new code in
corpus/, from where the next run goes on. Exits with 1 if there is a finding.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def formulas():
    """All formulas of the presets, of the language's page, and of the prelude."""
    for preset in sorted((ROOT / "presets").rglob("*.json")):
        formula = json.loads(preset.read_text(encoding="utf-8"))["formula"]
        yield formula if isinstance(formula, str) else "\n".join(formula)
    page = (ROOT / "docs" / "language.md").read_text(encoding="utf-8")
    yield from re.findall(r"^```zeroset\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    for definition in sorted((ROOT / "src" / "formula").rglob("*.zeroset")):
        yield definition.read_text(encoding="utf-8")


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--fuzzer", type=pathlib.Path, required=True)
    arguments.add_argument("--seconds", type=int, default=20)
    arguments.add_argument("--seed", type=int, default=1)
    given = arguments.parse_args()

    home = given.fuzzer.parent
    seeds, corpus, findings = home / "seeds", home / "corpus", home / "findings"
    for folder in (seeds, corpus, findings):
        folder.mkdir(exist_ok=True)
    for number, text in enumerate(formulas()):
        (seeds / f"{number:03}").write_text(text, encoding="utf-8")

    command = [
        given.fuzzer,
        f"-max_total_time={given.seconds}",
        f"-seed={given.seed}",
        f"-dict={pathlib.Path(__file__).with_name('language.dict')}",
        f"-artifact_prefix={findings}/",
        "-max_len=4096",
        "-timeout=10",
        "-rss_limit_mb=2048",
        "-print_final_stats=1",
        corpus,
        seeds,
    ]
    print(f"seed {given.seed}, {given.seconds} s", flush=True)
    return 1 if subprocess.run(command, check=False).returncode else 0


if __name__ == "__main__":
    sys.exit(main())
