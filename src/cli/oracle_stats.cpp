// SPDX-License-Identifier: MIT
#include "cli/oracle_stats.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

namespace cli {

std::string oracle_stats_json(const oracle::Reference& reference, double seconds) {
    std::array<long long, 3> count{};
    long long fragile = 0, estimated = 0;
    double widest = 0;
    for (const oracle::Pixel& pixel : reference.pixels) {
        ++count[static_cast<std::size_t>(pixel.verdict)];
        fragile += pixel.fragile;
        estimated += pixel.estimated;
        if (pixel.verdict != oracle::Verdict::hit || !(pixel.far > 0)) continue;
        widest = std::max(widest, (pixel.far - pixel.near) / pixel.far);
    }
    const auto counted = [&](oracle::Verdict verdict) {
        return count[static_cast<std::size_t>(verdict)];
    };
    nlohmann::ordered_json json;
    json["width"] = reference.width;
    json["height"] = reference.height;
    json["seconds"] = seconds;
    json["pixels"] = {{"hit", counted(oracle::Verdict::hit)},
                      {"miss", counted(oracle::Verdict::miss)},
                      {"undecided", counted(oracle::Verdict::undecided)},
                      {"fragile", fragile},
                      {"estimated", estimated}};
    json["heuristic"] = reference.heuristic;
    json["largest_enclosure"] = widest;
    return json.dump(2) + '\n';
}

}  // namespace cli
