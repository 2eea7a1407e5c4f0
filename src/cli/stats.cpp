// SPDX-License-Identifier: MIT
#include "cli/stats.h"

#include <array>

#include <nlohmann/json.hpp>

#include "cli/step_rules_json.h"
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

/// Field evaluations of the primary rays.
long long evaluations(const render::Still& counted) {
    double sum = 0;
    for (std::size_t i = 3; i < counted.normal.values.size(); i += 4) {
        sum += shader::evaluations_in(counted.normal.values[i]);
    }
    return static_cast<long long>(sum);
}

std::array<long long, shader::certificate_count> certificates(const render::Still& counted) {
    std::array<long long, shader::certificate_count> count{};
    for (std::size_t i = 3; i < counted.normal.values.size(); i += 4) {
        ++count[static_cast<std::size_t>(shader::certificate_in(counted.normal.values[i]))];
    }
    return count;
}

}  // namespace

std::string stats_json(const render::Still& still, const render::Still& counted,
                       const RunFacts& facts) {
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
    json["precision"] = facts.precision;
    json["precision_reason"] = facts.precision_reason;
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
    const auto proven = certificates(counted);
    const auto add = [&](const char* name, shader::Certificate certificate) {
        json["pixels"][name] = proven[static_cast<std::size_t>(certificate)];
    };
    add("proven_hit", shader::Certificate::proven_hit);
    add("proven_miss", shader::Certificate::proven_miss);
    add("hit_within_rounding", shader::Certificate::hit_within_rounding);
    add("miss_within_rounding", shader::Certificate::miss_within_rounding);
    add("heuristic_hit", shader::Certificate::heuristic_hit);
    add("heuristic_miss", shader::Certificate::heuristic_miss);
    json["steps"] = {{"mean", steps / pixels},
                     {"most", most_steps},
                     {"summary", compile::summary(facts.rules)},
                     {"by", step_rules_json(facts.rules)}};
    json["evaluations"] = evaluations(counted);
    if (facts.bricks) json["bricks"] = bricks_json(*facts.bricks, facts.brick_seconds);
    return json.dump(2) + '\n';
}

}  // namespace cli
