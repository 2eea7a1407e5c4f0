#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tells which files of src/ break the architecture.

Links alone enforce nothing, because all folders share one include root. So the edges that each
src/<folder>/CMakeLists.txt declares are read from there, and every include is held against them.
Use: check_layers.py SRC; prints one line for each violation and exits with 1 if there is one.
"""
import graphlib
import re
import sys
from pathlib import Path

# Who may include a third party's headers: folders, or single files.
OWNERS = {
    "GL/": {"render"},
    "EGL/": {"render"},
    "GLFW/": {"studio"},
    "imgui": {"studio"},
    "backends/imgui": {"studio"},
    "nlohmann/": {"scene", "cli", "bench"},
    "boost/spirit": {"formula/grammar.cpp"},
}

COMMAND = re.compile(r"\b(add_library|add_executable|target_link_libraries)\s*\(([^)]*)\)")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)


def read_cmake(path):
    """The words of each CMake command of interest, comments dropped."""
    text = re.sub(r"#.*", "", path.read_text())
    return [(name, words.split()) for name, words in COMMAND.findall(text)]


def check_includes(file, name, allowed, folders):
    for quote, target in INCLUDE.findall(file.read_text()):
        folder = target.split("/")[0]
        if quote == '"' and folder not in folders:
            yield f'{name}: write "{target}" as "folder/file"'
        elif quote == '"' and folder not in allowed:
            yield f'{name}: includes "{target}", but its CMakeLists.txt does not link {folder}'
        for prefix, owners in OWNERS.items():
            if target.startswith(prefix) and not {name, name.split("/")[0]} & owners:
                yield f"{name}: only {' and '.join(sorted(owners))} may include <{target}>"


def violations(src):
    folders = {path.parent.name for path in src.glob("*/CMakeLists.txt")}
    edges = {}
    for folder in sorted(folders):
        commands = read_cmake(src / folder / "CMakeLists.txt")
        links = {w for name, words in commands if name == "target_link_libraries" for w in words}
        listed = {w for name, words in commands if name != "target_link_libraries" for w in words}
        edges[folder] = links & folders - {folder}
        for file in sorted((src / folder).rglob("*")):
            if file.suffix not in {".h", ".cpp", ".def"}:
                continue
            name = file.relative_to(src).as_posix()
            if file.suffix == ".cpp" and file.relative_to(src / folder).as_posix() not in listed:
                yield f"{name}: not listed in its CMakeLists.txt"
            yield from check_includes(file, name, edges[folder] | {folder}, folders)
    try:
        graphlib.TopologicalSorter(edges).prepare()
    except graphlib.CycleError as cycle:
        yield f"src: libraries link each other in a circle: {' -> '.join(cycle.args[1])}"


def main():
    found = list(violations(Path(sys.argv[1])))
    print("\n".join(found) or "the layers are kept")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
