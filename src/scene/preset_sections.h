// SPDX-License-Identifier: MIT
// The parts of a preset, in the order in which they are written: for each how it is read and how it
// is written.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "scene/document.h"
#include "scene/preset_reading.h"

namespace scene {

struct Section {
    std::string_view name;
    void (*read)(const Json& json, const Place& place, Reading& reading, Document& document);
    /// Nothing if the part is as by default, unless it is asked for because unknown fields belong
    /// to it.
    std::optional<Json> (*write)(const Document& document, bool asked_for);
};

std::span<const Section> sections();

}  // namespace scene
