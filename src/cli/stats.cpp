// SPDX-License-Identifier: MIT
#include "cli/stats.h"

#include <array>

#include <nlohmann/json.hpp>

#include "shader/program_source.h"

namespace cli {

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
    return json.dump(2) + '\n';
}

}  // namespace cli
