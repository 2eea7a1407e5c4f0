// SPDX-License-Identifier: MIT
#include "cli/stats.h"

#include <array>

#include <nlohmann/json.hpp>

#include "shader/program_source.h"

namespace cli {
namespace {

/// How many bricks all grids have (one for each formula that has bricks, one for the scene if it
/// skips by them), in how many of them no surface is, and in how many that may have one
/// steps are certified; and how long that took.
nlohmann::ordered_json bricks_json(const shader::BrickTexels& bricks, double seconds) {
    std::size_t empty = 0, certified = 0;
    for (std::size_t i = 0; i < bricks.texels.size(); i += 2) {
        const bool holds_nothing = bricks.texels[i + 1] < 0;
        empty += holds_nothing;
        certified += !holds_nothing && bricks.texels[i] > 0;
    }
    return {{"grids", bricks.grids}, {"side", bricks.side},    {"count", bricks.texels.size() / 2},
            {"empty", empty},        {"certified", certified}, {"seconds", seconds}};
}

}  // namespace

std::string stats_json(const render::Still& still, const RunFacts& facts) {
    std::array<long long, 3> count{};
    double steps = 0;
    int most_steps = 0;
    const auto& geometry = still.geometry;
    for (std::size_t i = 0; i < geometry.values.size(); i += 4) {
        ++count[static_cast<std::size_t>(geometry.values[i + 2])];
        steps += geometry.values[i + 1];
        most_steps = std::max(most_steps, static_cast<int>(geometry.values[i + 1]));
    }
    const double pixels = std::max(1.0, geometry.values.size() / 4.0);
    nlohmann::ordered_json json;
    json["tracer"] = facts.tracer;
    json["backend"] = facts.backend;
    json["renderer"] = facts.renderer;
    json["width"] = geometry.width;
    json["height"] = geometry.height;
    json["seconds"] = {{"parse", facts.parse_seconds},
                       {"analyse", facts.analyse_seconds},
                       {"link", still.link_seconds},
                       {"first_frame", still.first_frame_seconds},
                       {"frames", still.frame_seconds}};
    json["pixels"] = {{"hit", count[static_cast<int>(shader::Status::hit)]},
                      {"miss", count[static_cast<int>(shader::Status::miss)]},
                      {"unresolved", count[static_cast<int>(shader::Status::unresolved)]}};
    json["steps"] = {{"mean", steps / pixels}, {"most", most_steps}};
    if (facts.evaluations) json["evaluations"] = static_cast<long long>(*facts.evaluations);
    if (facts.bricks) json["bricks"] = bricks_json(*facts.bricks, facts.brick_seconds);
    return json.dump(2) + '\n';
}

}  // namespace cli
