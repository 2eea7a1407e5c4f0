// SPDX-License-Identifier: MIT
#include "studio/preset_list.h"

#include <algorithm>
#include <tuple>

#include "base/file.h"
#include "scene/preset.h"
#include "studio/document_file.h"

namespace studio {
namespace {

PresetEntry entry(const std::filesystem::path& folder, const std::filesystem::path& relative) {
    PresetEntry result{.file = folder / relative,
                       .folder = relative.parent_path().generic_string(),
                       .title = relative.stem().string(),
                       .problem = {}};
    const auto text = base::read_text(result.file, scene::largest_preset);
    if (!text) {
        result.problem = text.problems().front().message;
        return result;
    }
    const auto preset = scene::read_preset(*text);
    if (!preset) {
        result.problem = preset.problems().front().message;
    } else if (!preset->document.title.empty()) {
        result.title = preset->document.title;
    }
    return result;
}

std::vector<PresetEntry> entries(const std::filesystem::path& folder) {
    std::vector<PresetEntry> list;
    if (folder.empty()) return list;
    for (const auto& relative : scene::list_presets(folder)) {
        list.push_back(entry(folder, relative));
    }
    std::stable_sort(list.begin(), list.end(), [](const PresetEntry& a, const PresetEntry& b) {
        return std::tie(a.folder, a.title) < std::tie(b.folder, b.title);
    });
    return list;
}

}  // namespace

PresetLists list_all_presets() {
    return {entries(scene::shipped_presets_folder()), entries(scene::user_presets_folder())};
}

}  // namespace studio
