// SPDX-License-Identifier: MIT
// The part `parameters` of a preset.
#pragma once

#include <optional>

#include "scene/document.h"
#include "scene/preset_reading.h"

namespace scene {

/// Reads values by name: numbers, lists of 2 to 4 numbers, texts, true or false.
void read_parameters(const Json& json, const Place& place, Reading& reading, Document& document);

/// The values in their natural form; those that JSON cannot hold are left out.
std::optional<Json> write_parameters(const Document& document, bool asked_for);

}  // namespace scene
