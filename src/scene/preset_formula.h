// SPDX-License-Identifier: MIT
// The formula in a preset: one text, or a list of lines.
#pragma once

#include <optional>

#include "scene/preset_reading.h"

namespace scene {

/// Also fills the reading's formula_places.
void read_formula(const Json& json, const Place& place, Reading& reading, Document& document);
std::optional<Json> write_formula(const Document& document, bool asked_for);

}  // namespace scene
