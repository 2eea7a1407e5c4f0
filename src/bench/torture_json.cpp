// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/pages.h"

namespace bench {

base::Result<std::vector<TortureScene>> read_torture(std::string_view text,
                                                     const std::string& name) {
    using Json = nlohmann::ordered_json;
    try {
        std::vector<TortureScene> list;
        const Json json = Json::parse(text);
        for (const auto& [scene_name, found] : json.at("scenes").items()) {
            TortureScene scene;
            scene.name = scene_name;
            found.at("reference").at("compared").get_to(scene.compared);
            found.at("reference").at("undecided").get_to(scene.undecided);
            for (const auto& [tracer, counts] : found.at("tracers").items()) {
                scene.tracers[tracer] = {counts.at("missed").get<std::size_t>(),
                                         counts.at("phantom").get<std::size_t>(),
                                         counts.at("moved").get<std::size_t>(),
                                         counts.at("unresolved").get<std::size_t>()};
            }
            list.push_back(std::move(scene));
        }
        return list;
    } catch (const Json::exception&) {
        return base::error(fmt::format(
            "'{}' is no record of the torture suite; it is tests/torture/known_failures.json",
            name));
    }
}

base::Result<std::vector<PrecisionLimit>> read_precision_limits(std::string_view text,
                                                                const std::string& name) {
    using Json = nlohmann::ordered_json;
    try {
        std::vector<PrecisionLimit> list;
        const Json json = Json::parse(text);
        for (const auto& [fractal, found] : json.items()) {
            PrecisionLimit limit{fractal, found.at("limit").get<double>(), {}};
            for (const Json& step : found.at("steps")) {
                limit.steps.push_back(
                    {step.at("zoom").get<double>(), step.at("wrong_share").get<double>()});
            }
            list.push_back(std::move(limit));
        }
        return list;
    } catch (const Json::exception&) {
        return base::error(fmt::format(
            "'{}' has no limits of precision; it is tests/torture/precision_limits.json", name));
    }
}

}  // namespace bench
