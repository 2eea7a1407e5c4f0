// SPDX-License-Identifier: MIT
// The scenes of the torture suite: presets below tests/torture/scenes, each aimed at one weakness.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compile/compile.h"
#include "scene/document.h"

namespace torture {

/// Of every picture of the suite.
inline constexpr int width = 64;
inline constexpr int height = 48;

struct Scene {
    std::string name;  ///< the preset's path without its ending
    scene::Document document;
    compile::Formula formula;
};

/// Names of all scenes, sorted.
std::vector<std::string> scene_names();

/// Fails the test and returns an empty scene on errors.
Scene read_scene(const std::string& name);

/// As a test's name may be spelt.
std::string test_name(const std::string& scene_name);

/// All messages, a line each.
std::string text_of(const base::Diagnostics& problems);

}  // namespace torture
