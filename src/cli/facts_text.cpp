// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/facts.h"

namespace cli {
namespace {

using analysis::Facts;

std::string degree(const Facts& facts) {
    return facts.degree ? fmt::format("{}", *facts.degree) : "no polynomial";
}

std::string smoothness(const Facts& facts) {
    std::string_view smooth;
    switch (facts.regularity.smoothness) {
        case analysis::Smoothness::smooth:
            smooth = "smooth";
            break;
        case analysis::Smoothness::piecewise:
            smooth = "continuous, may have kinks";
            break;
        case analysis::Smoothness::discontinuous:
            smooth = "may jump";
            break;
    }
    return fmt::format(
        "{}, {}", smooth,
        facts.regularity.partial ? "may be undefined at places" : "defined everywhere");
}

std::string metric(const Facts& facts) {
    switch (facts.metric) {
        case analysis::Metric::exact:
            return "exact";
        case analysis::Metric::bound:
            return "never more than the distance";
        case analysis::Metric::estimate:
            return "a heuristic estimate";
        case analysis::Metric::none:
            break;
    }
    if (!std::isfinite(facts.lipschitz)) return "no";
    return fmt::format("no; changes by at most {:.4g} a unit", facts.lipschitz);
}

std::string extent(const Facts& facts) {
    if (!facts.box) return "nothing is in the bounds";
    if (facts.full) return "fills the bounds";
    const glm::dvec3 &low = facts.box->low, &high = facts.box->high;
    std::string_view further;
    switch (facts.reach) {
        case analysis::Reach::bounded:
            further = "nothing outside";
            break;
        case analysis::Reach::contained:
            further = "away from the bounds";
            break;
        case analysis::Reach::open:
            further = "may go on outside of the bounds";
            break;
    }
    return fmt::format("[{:.4g}, {:.4g}] x [{:.4g}, {:.4g}] x [{:.4g}, {:.4g}], {}", low.x, high.x,
                       low.y, high.y, low.z, high.z, further);
}

std::string dependence(const Facts& facts, const graph::Graph& graph) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < 3; ++i) {
        if (facts.dependence.point[i]) names.emplace_back(1, "xyz"[i]);
    }
    if (facts.dependence.time) names.emplace_back("t");
    for (const graph::ParameterId id : facts.dependence.parameters) names.push_back(graph.name(id));
    return names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", "));
}

std::string operations(const Facts& facts) {
    std::string text = fmt::format("{} a point", facts.cost.point);
    if (facts.cost.turn > 0) text += fmt::format(", {} a turn", facts.cost.turn);
    return text + fmt::format(", {} a frame", facts.cost.hoisted);
}

std::string paragraph(const std::string& title, const Facts& facts, const graph::Graph& graph) {
    const auto line = [](std::string_view name, const std::string& value) {
        return fmt::format("  {:<12}{}\n", name, value);
    };
    const bool sheet = facts.kind == field::Kind::sheet;
    return fmt::format("{}: {}\n", title, sheet ? "sheet" : "solid") +
           line("degree", degree(facts)) + line("smoothness", smoothness(facts)) +
           line("distance", metric(facts)) + line("extent", extent(facts)) +
           line("depends on", dependence(facts, graph)) + line("operations", operations(facts));
}

/// How a ray's steps are found, with tracer and settings of the preset.
std::string steps(std::span<const compile::StepRule> rules) {
    if (rules.size() == 1) return fmt::format("steps: {}\n", describe(rules[0]));
    std::string text = "steps:\n";
    for (const compile::StepRule& rule : rules) {
        const std::size_t first = rule.first_object + 1, last = rule.first_object + rule.objects;
        const std::string name =
            first == last ? fmt::format("object {}", first) : fmt::format("{} to {}", first, last);
        text += fmt::format("  {:<12}{}\n", name, describe(rule));
    }
    return text;
}

}  // namespace

std::string facts_text(const analysis::SceneFacts& facts, const graph::Graph& graph,
                       std::span<const compile::StepRule> rules) {
    if (facts.objects.size() == 1) return paragraph("scene", facts.whole, graph) + steps(rules);
    std::string text =
        paragraph(fmt::format("scene of {} objects", facts.objects.size()), facts.whole, graph);
    for (std::size_t i = 0; i < facts.objects.size(); ++i) {
        text += paragraph(fmt::format("object {}", i + 1), facts.objects[i], graph);
    }
    return text + steps(rules);
}

}  // namespace cli
