// SPDX-License-Identifier: MIT
#include "cli/output_file.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace cli {

base::Status check_writable(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (fs::is_directory(path, error)) {
        return base::error(
            fmt::format("cannot write '{}': it is a folder; name a file in it", path));
    }
    const fs::path parent = fs::path(path).parent_path();
    const fs::path folder = parent.empty() ? fs::path(".") : parent;
    if (!fs::is_directory(folder, error)) {
        return base::error(fmt::format(
            "cannot write '{}': there is no folder '{}'; create it or choose another place", path,
            folder.string()));
    }
    const bool exists = fs::exists(path, error);
    if (access(exists ? path.c_str() : folder.c_str(), W_OK) != 0) {
        return base::error(fmt::format(
            "cannot write '{}': permission denied; choose a place that you may write to", path));
    }
    return base::Done{};
}

}  // namespace cli
