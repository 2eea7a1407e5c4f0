// SPDX-License-Identifier: MIT
// The presets that the user can choose from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace studio {

struct PresetEntry {
    std::filesystem::path file;
    std::string folder;   ///< below the list's own folder; empty at its top
    std::string title;    ///< the preset's, else the file's name
    std::string problem;  ///< why it cannot be opened; empty if it can
};

/// Shipped ones and the user's own, sorted by folder, then by title.
struct PresetLists {
    std::vector<PresetEntry> shipped, own;
};

/// Reads all presets' titles.
PresetLists list_all_presets();

}  // namespace studio
