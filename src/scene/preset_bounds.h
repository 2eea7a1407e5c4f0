// SPDX-License-Identifier: MIT
// The bounds in a preset: {"sphere": R}, {"sphere": [x, y, z, R]}, {"box": [hx, hy, hz]},
// {"box": [x, y, z, hx, hy, hz]} or "none".
#pragma once

#include <optional>

#include "scene/preset_reading.h"

namespace scene {

void read_bounds(const Json& json, const Place& place, Reading& reading, Document& document);
std::optional<Json> write_bounds(const Document& document, bool asked_for);

}  // namespace scene
