// SPDX-License-Identifier: MIT
// Where presets are, and which one a name means.
#include <algorithm>
#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

#include "scene/near_name.h"
#include "scene/preset.h"

namespace scene {
namespace {

namespace fs = std::filesystem;

fs::path variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? fs::path(value) : fs::path();
}

bool is_folder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

/// "surfaces/heart" for surfaces/heart.json.
std::string name_of(const fs::path& relative) {
    return fs::path(relative).replace_extension().generic_string();
}

/// The preset of a folder that a name means, or an empty path.
fs::path look_up(const fs::path& folder, const std::string& name) {
    const std::string wanted = name.ends_with(".json") ? name.substr(0, name.size() - 5) : name;
    for (const fs::path& relative : list_presets(folder)) {
        if (wanted == name_of(relative) || wanted == relative.stem().string()) {
            return folder / relative;
        }
    }
    return {};
}

std::vector<std::string> near_candidates(const std::string& name) {
    std::vector<std::string> candidates;
    const bool with_folder = name.find('/') != std::string::npos;
    for (const fs::path& folder : {user_presets_folder(), shipped_presets_folder()}) {
        for (const fs::path& relative : list_presets(folder)) {
            candidates.push_back(with_folder ? name_of(relative) : relative.stem().string());
        }
    }
    const fs::path parent = fs::path(name).parent_path();
    std::error_code failure;
    for (fs::directory_iterator at(parent.empty() ? "." : parent, failure), end;
         !failure && at != end; at.increment(failure)) {
        if (at->path().extension() != ".json") continue;
        candidates.push_back((parent / at->path().filename()).generic_string());
    }
    std::sort(candidates.begin(), candidates.end());
    return candidates;
}

}  // namespace

fs::path shipped_presets_folder() {
    const fs::path chosen = variable("ZEROSET_PRESETS");
    if (!chosen.empty()) return chosen;
    std::error_code failure;
    const fs::path program = fs::read_symlink("/proc/self/exe", failure).parent_path();
    for (const char* place : {"presets", "../presets", "../share/zeroset/presets"}) {
        const fs::path folder = (program / place).lexically_normal();
        if (!failure && is_folder(folder)) return folder;
    }
    return {};
}

fs::path user_presets_folder() {
    const fs::path data = variable("XDG_DATA_HOME");
    if (data.is_absolute()) return data / "zeroset" / "presets";
    const fs::path home = variable("HOME");
    return home.empty() ? fs::path() : home / ".local" / "share" / "zeroset" / "presets";
}

std::vector<fs::path> list_presets(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code failure;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied,
                                        failure);
    for (; !failure && at != fs::end(at); at.increment(failure)) {
        std::error_code ignored;
        if (at->path().extension() == ".json" && at->is_regular_file(ignored)) {
            found.push_back(at->path().lexically_relative(folder));
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

base::Result<fs::path> find_preset(const std::string& name) {
    if (name.empty()) return base::error("a preset needs a name");
    std::error_code ignored;
    const fs::file_status status = fs::status(name, ignored);
    if (fs::exists(status) && !fs::is_directory(status)) return fs::path(name);
    for (const fs::path& folder : {user_presets_folder(), shipped_presets_folder()}) {
        const fs::path found = look_up(folder, name);
        if (!found.empty()) return found;
    }
    if (fs::is_directory(status)) {
        return base::error(
            fmt::format("'{}' is a directory, not a preset; name a .json file in it", name));
    }
    std::string message = fmt::format("there is no preset '{}'", name);
    const std::string meant = near_name(name, near_candidates(name));
    message += meant.empty() ? "; give the path of a .json file, or a name such as 'barth_sextic'"
                             : fmt::format("; did you mean '{}'?", meant);
    return base::error(std::move(message));
}

}  // namespace scene
