// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "cli/comparison.h"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

Json spread(const oracle::Spread& spread) {
    return {{"median", spread.median},
            {"percentile_99", spread.percentile_99},
            {"largest", spread.largest}};
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
    const oracle::Metrics& m = comparison.metrics;
    Json json;
    json["heuristic"] = comparison.heuristic;
    json["pixels"] = {{"compared", m.compared}, {"wrong", m.wrong()},      {"missed", m.missed},
                      {"phantom", m.phantom},   {"moved", m.moved},        {"no_depth", m.no_depth},
                      {"fragile", m.fragile},   {"undecided", m.undecided}};
    json["depth_error"] = spread(m.depth_error);
    if (comparison.has_normals) json["normal_degrees"] = spread(m.normal_error);
    if (comparison.picture) {
        const image::Difference& d = *comparison.picture;
        json["picture"] = {{"mean", d.mean},
                           {"largest", d.largest},
                           {"changed", d.changed},
                           {"pixels", d.picture.values.size() / image::Picture::channels}};
    }
    return json.dump(2) + '\n';
}

}  // namespace cli
