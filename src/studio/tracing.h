// SPDX-License-Identifier: MIT
// How rays are traced: the settings that decide what a picture costs and how wrong it is.
#pragma once

#include <string>
#include <vector>

#include "scene/document.h"

namespace studio {

/// The members of scene::Settings by these names.
struct Tracing {
    std::string tracer;
    double lipschitz = 1;
    int steps = 0;
    double epsilon = 0;

    friend bool operator==(const Tracing&, const Tracing&) = default;
};

Tracing tracing_of(const scene::Settings& settings);
void apply(const Tracing& tracing, scene::Settings& settings);

/// What the present setting is compared with, itself first: its tracer with some Lipschitz scales,
/// and each other tracer with the scale 1; steps and epsilon are the present ones throughout. Each
/// setting is there once.
std::vector<Tracing> neighbours(const Tracing& present);

/// "sphere, Lipschitz scale 0.7".
std::string describe(const Tracing& tracing);

}  // namespace studio
