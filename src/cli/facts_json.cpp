// SPDX-License-Identifier: MIT
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/facts.h"
#include "cli/step_rules_json.h"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

const char* name(analysis::Smoothness smoothness) {
    switch (smoothness) {
        case analysis::Smoothness::smooth:
            return "smooth";
        case analysis::Smoothness::piecewise:
            return "piecewise";
        case analysis::Smoothness::discontinuous:
            break;
    }
    return "discontinuous";
}

const char* name(analysis::Metric metric) {
    switch (metric) {
        case analysis::Metric::exact:
            return "exact";
        case analysis::Metric::bound:
            return "bound";
        case analysis::Metric::estimate:
            return "estimate";
        case analysis::Metric::none:
            break;
    }
    return "none";
}

const char* name(analysis::Reach reach) {
    switch (reach) {
        case analysis::Reach::bounded:
            return "bounded";
        case analysis::Reach::contained:
            return "contained";
        case analysis::Reach::open:
            break;
    }
    return "open";
}

Json extent(const analysis::Facts& facts) {
    if (!facts.box) return nullptr;
    const glm::dvec3 &low = facts.box->low, &high = facts.box->high;
    return {{"low", {low.x, low.y, low.z}},
            {"high", {high.x, high.y, high.z}},
            {"reach", name(facts.reach)},
            {"full", facts.full}};
}

Json dependence(const analysis::Dependence& dependence, const graph::Graph& graph) {
    Json names = Json::array();
    for (std::size_t i = 0; i < 3; ++i) {
        if (dependence.point[i]) names.push_back(std::string(1, "xyz"[i]));
    }
    if (dependence.time) names.push_back("t");
    for (const graph::ParameterId id : dependence.parameters) names.push_back(graph.name(id));
    return names;
}

Json json(const analysis::Facts& facts, const graph::Graph& graph) {
    Json result;
    result["kind"] = facts.kind == field::Kind::sheet ? "sheet" : "solid";
    result["degree"] = facts.degree ? Json(*facts.degree) : Json(nullptr);
    result["smoothness"] = name(facts.regularity.smoothness);
    result["partial"] = facts.regularity.partial;
    result["metric"] = name(facts.metric);
    result["lipschitz"] = std::isfinite(facts.lipschitz) ? Json(facts.lipschitz) : Json(nullptr);
    result["extent"] = extent(facts);
    result["depends"] = dependence(facts.dependence, graph);
    result["operations"] = {
        {"point", facts.cost.point}, {"turn", facts.cost.turn}, {"hoisted", facts.cost.hoisted}};
    return result;
}

}  // namespace

std::string facts_json(const analysis::SceneFacts& facts, const graph::Graph& graph,
                       std::span<const compile::StepRule> rules) {
    Json result;
    result["scene"] = json(facts.whole, graph);
    result["objects"] = Json::array();
    for (const analysis::Facts& object : facts.objects) {
        result["objects"].push_back(json(object, graph));
    }
    result["steps"] = step_rules_json(rules);
    return result.dump(2) + '\n';
}

}  // namespace cli
