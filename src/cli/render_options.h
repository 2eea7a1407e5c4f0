// SPDX-License-Identifier: MIT
// The options that say what is looked at and how it is drawn.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cli/input.h"
#include "render/frame.h"

namespace CLI {
class App;
}

namespace cli {

struct RenderOptions {
    int width = 1280;
    int height = 720;
    std::optional<std::array<int, 4>> region;  ///< x, y, width, height
    std::optional<glm::dvec3> eye, target, up;
    std::optional<double> fov;
    std::optional<scene::Bounds> bounds;
    std::vector<std::pair<std::string, std::string>> parameters;  ///< name and value as typed
    std::optional<std::string> tracer, precision;
    std::optional<int> steps;
    std::optional<double> lipschitz, shadow, epsilon;
    bool no_shadow = false;
    bool no_ambient_occlusion = false;
    bool show_steps = false;
    std::string backend = "osmesa";

    render::View view() const;
};

/// Adds all of them to a subcommand. Values that make no sense are refused while parsing.
void add_render_options(CLI::App& command, RenderOptions& options);

/// Puts the options over the document of an input and completes its camera. False, after a report,
/// if a parameter is unknown or its value does not suit it, or if eye and target are one.
bool apply(const RenderOptions& options, Input& input);

}  // namespace cli
