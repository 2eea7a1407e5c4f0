// SPDX-License-Identifier: MIT
// Documents as JSON files (docs/presets.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/document.h"

namespace scene {

/// The version that is written. Older ones are migrated on reading, newer ones are an error.
inline constexpr int preset_version = 1;

/// A preset as read, with what is needed to report problems of its formula and of its parameters at
/// their places in the file.
struct Preset {
    Document document;
    base::Diagnostics warnings;  ///< unknown fields; spans are bytes of the file's text
    /// For each byte of document.formula (and its end) the byte of the file that it stands at.
    std::vector<std::uint32_t> formula_places;
    /// Whether the values suit the formula is not known here (compile::check_parameters).
    ParameterPlaces parameter_places;
};

/// Reads a preset's text. Every problem has the span in that text; all are reported, not only the
/// first. NaN and infinities, wrong types, numbers out of range, a missing formula, broken UTF-8,
/// a truncated text and a newer version are errors.
base::Result<Preset> read_preset(std::string_view text);

/// The preset's text: two spaces of indentation, fixed order of fields, numbers in the shortest
/// form that reads back the same, only what differs from the defaults, a newline at the end.
std::string write_preset(const Document& document);

/// A larger preset file is not read (base::read_text).
inline constexpr std::size_t largest_preset = 4 * 1024 * 1024;

/// The shipped presets' folder: $ZEROSET_PRESETS, or `presets` beside or above the program, or
/// ../share/zeroset/presets; empty if there is none.
std::filesystem::path shipped_presets_folder();
/// Where the user's own presets go: $XDG_DATA_HOME/zeroset/presets, else under ~/.local/share.
std::filesystem::path user_presets_folder();

/// All .json files below a folder, sorted, as paths relative to it.
std::vector<std::filesystem::path> list_presets(const std::filesystem::path& folder);

/// The file that a user means: a path as given, or the name of a shipped or own preset with or
/// without folder and .json ("heart", "surfaces/heart"). An error suggests near names.
base::Result<std::filesystem::path> find_preset(const std::string& name);

}  // namespace scene
