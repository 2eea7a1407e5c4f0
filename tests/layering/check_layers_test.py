#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants one violation at a time in a small tree and expects the check to name it."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
from check_layers import violations  # noqa: E402

CLEAN = {
    "base/CMakeLists.txt": "add_library(base STATIC text.cpp)\n",
    "base/text.h": "#include <string>\n",
    "base/text.cpp": '#include "base/text.h"\n',
    "scene/CMakeLists.txt": "add_library(scene STATIC\n  scene.cpp  # one\n)\n"
    "target_link_libraries(scene PUBLIC base\n  PRIVATE fmt::fmt)\n",
    "scene/scene.cpp": '#include "base/text.h"\n#include <nlohmann/json.hpp>\n',
    "render/CMakeLists.txt": "add_library(render STATIC gl.cpp)\n"
    "target_link_libraries(render PUBLIC scene base)\n",
    "render/gl.cpp": '#include <GL/glcorearb.h>\n#include "scene/scene.h"\n',
    "formula/CMakeLists.txt": "add_library(formula STATIC grammar.cpp)\n",
    "formula/grammar.cpp": "#include <boost/spirit/home/x3.hpp>\n",
    "cli/CMakeLists.txt": "add_library(cli STATIC render_command.cpp)\n"
    "target_link_libraries(cli PUBLIC render)\n"
    "add_executable(zeroset main.cpp)\ntarget_link_libraries(zeroset PRIVATE cli base)\n",
    "cli/render_command.cpp": '#include "render/gl.h"\n',
    "cli/main.cpp": '#include "cli/render_command.h"\n#include "base/text.h"\n',
}


class CheckLayers(unittest.TestCase):
    def found(self, **planted):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (CLEAN | planted.get("files", {})).items():
                path = Path(folder, name)
                path.parent.mkdir(exist_ok=True)
                path.write_text(text)
            return list(violations(Path(folder)))

    def test_a_clean_tree_has_no_violations(self):
        self.assertEqual(self.found(), [])

    def test_an_include_that_is_not_linked(self):
        self.assertEqual(
            self.found(files={"base/text.h": '#include "scene/scene.h"\n'}),
            ['base/text.h: includes "scene/scene.h", but its CMakeLists.txt does not link scene'],
        )

    def test_a_link_in_a_comment_is_no_link(self):
        files = {
            "render/CMakeLists.txt": "add_library(render STATIC gl.cpp)\n"
            "target_link_libraries(render PUBLIC base)  # scene\n"
        }
        self.assertEqual(
            self.found(files=files),
            ['render/gl.cpp: includes "scene/scene.h", but its CMakeLists.txt does not link scene'],
        )

    def test_a_link_of_a_link_is_no_link(self):
        self.assertEqual(
            self.found(files={"cli/render_command.cpp": '# include "scene/scene.h"\n'}),
            [
                'cli/render_command.cpp: includes "scene/scene.h", but its CMakeLists.txt does not '
                "link scene"
            ],
        )

    def test_an_include_without_a_folder(self):
        self.assertEqual(
            self.found(files={"base/text.cpp": '#include "text.h"\n'}),
            ['base/text.cpp: write "text.h" as "folder/file"'],
        )

    def test_third_parties_stay_with_their_owners(self):
        for header, owners in (
            ("GL/gl.h", "render"),
            ("EGL/egl.h", "render"),
            ("GLFW/glfw3.h", "studio"),
            ("imgui.h", "studio"),
            ("backends/imgui_impl_glfw.h", "studio"),
            ("nlohmann/json.hpp", "bench and cli and scene"),
            ("boost/spirit/home/x3.hpp", "formula/grammar.cpp"),
        ):
            self.assertEqual(
                self.found(files={"base/text.h": f"#include <{header}>\n"}),
                [f"base/text.h: only {owners} may include <{header}>"],
            )

    def test_the_parsers_headers_stay_in_one_file_of_their_folder(self):
        files = {
            "formula/CMakeLists.txt": "add_library(formula STATIC ast.cpp grammar.cpp)\n",
            "formula/ast.cpp": "#include <boost/spirit/home/x3.hpp>\n",
        }
        self.assertEqual(
            self.found(files=files),
            [
                "formula/ast.cpp: only formula/grammar.cpp may include "
                "<boost/spirit/home/x3.hpp>"
            ],
        )

    def test_a_source_that_is_not_listed(self):
        self.assertEqual(
            self.found(files={"base/forgotten.cpp": ""}),
            ["base/forgotten.cpp: not listed in its CMakeLists.txt"],
        )

    def test_libraries_that_link_each_other(self):
        files = {
            "base/CMakeLists.txt": "add_library(base STATIC text.cpp)\n"
            "target_link_libraries(base PUBLIC scene)\n"
        }
        self.assertRegex(
            "\n".join(self.found(files=files)),
            "^src: libraries link each other in a circle: (base -> scene -> base|"
            "scene -> base -> scene)$",
        )


if __name__ == "__main__":
    unittest.main()
