// SPDX-License-Identifier: MIT
// `zeroset compare`: how wrong a picture is.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cli {

struct CompareOptions {
    std::string reference;              ///< a reference file, or a grey PFM of depths
    std::string depth;                  ///< of what is judged
    std::vector<std::string> normals;   ///< of what is judged, after those of a PFM
    std::vector<std::string> pictures;  ///< of both, or none
    double fov = 45;                    ///< vertical; of a PFM
    std::string json;                   ///< empty: text on standard output; `-`: standard output
    std::string marked;                 ///< where to write the marked picture, or empty
    std::optional<long long> fail_above;
};

/// Adds the subcommand `compare`.
CLI::App* add_compare(CLI::App& app, CompareOptions& options);

int compare_command(const CompareOptions& options);

}  // namespace cli
