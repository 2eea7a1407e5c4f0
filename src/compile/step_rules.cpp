// SPDX-License-Identifier: MIT
#include "compile/step_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "field/overloaded.h"
#include "field/parts.h"

namespace compile {
namespace {

using field::FieldId;
using graph::Op;
using shader::FieldValue;

bool may_jump(Op op) {
    return op == Op::floor || op == Op::ceil || op == Op::sign || op == Op::select_less ||
           op == Op::atan2;
}

class Rules {
public:
    Rules(const field::Field& field, const shader::ProgramSource& source,
          const shader::FieldNumbers& numbers, const scene::Document& document)
        : field_(field), source_(source), numbers_(numbers), document_(document) {}

    std::vector<StepRule> list() {
        visit(field_.root);
        return std::move(rules_);
    }

private:
    void visit(FieldId id) {
        std::visit(field::Overloaded{
                       [&](const field::Formula& leaf) { add(id, formula(id, leaf)); },
                       [&](const field::Iteration&) { add(id, iteration(id)); },
                       [&](const field::Blend&) { add(id, blend(id)); },
                       [&](const field::Cells& cells) {
                           ++cells_;
                           visit(cells.a);
                           --cells_;
                       },
                       [&](const auto&) {
                           for (const FieldId child : children(field_[id])) visit(child);
                       },
                   },
                   field_[id]);
    }

    std::size_t next_object() const {
        return rules_.empty() ? 0 : rules_.back().first_object + rules_.back().objects;
    }

    void add(FieldId id, StepRule rule) {
        rule.first_object = next_object();
        rule.objects = leaves(field_, id).size();
        const std::string& tracer = document_.settings.tracer;
        const bool steps_are_proven =
            tracer == "auto" || tracer == "sphere" || tracer == "relaxed" || tracer == "interval";
        const bool iterates = rule.by == StepRule::By::estimate;
        const bool own = tracer == "march" || (!iterates && rule.by != StepRule::By::distance);
        if (!steps_are_proven && own) {
            rule.by = StepRule::By::tracer;
            rule.doubt = StepRule::Doubt::chosen;
        }
        rules_.push_back(rule);
    }

    /// The first number of this kind that the program gets for the node.
    const double* number(FieldValue::What what, FieldId id) const {
        for (std::size_t i = 0; i < source_.field_values.size(); ++i) {
            const FieldValue& value = source_.field_values[i];
            if (value.what == what && value.node == id) return &numbers_.values[i];
        }
        return nullptr;
    }

    StepRule formula(FieldId id, const field::Formula& leaf) const {
        StepRule rule;
        const std::string& tracer = document_.settings.tracer;
        if (tracer == "interval" && cells_ == 0) {
            rule.by = StepRule::By::intervals;
            return rule;
        }
        const bool by_values = tracer == "sphere" || tracer == "relaxed";
        const double* inverse = number(FieldValue::What::inverse_lipschitz, id);
        const double* bend = number(FieldValue::What::second_derivative, id);
        const double* first = number(FieldValue::What::first_order, id);
        if (leaf.metric == field::Metric::distance && !inverse) {
            rule.lipschitz = 1;
            return rule;
        }
        if (inverse && *inverse > 0) rule.lipschitz = 1.0 / *inverse;
        if (bend && *bend >= 0 && !by_values) rule.second_derivative = *bend;
        if (source_.polynomials.contains(next_object())) {
            rule.by = StepRule::By::polynomial;
            return rule;
        }
        const auto grid = std::ranges::find(source_.bricks, id);
        if (grid != source_.bricks.end() && numbers_.bricks) {
            return of_bricks(static_cast<std::size_t>(grid - source_.bricks.begin()), leaf.value);
        }
        rule.by = std::isfinite(rule.second_derivative) ? StepRule::By::second_derivative
                                                        : StepRule::By::lipschitz;
        const bool unknown = std::isinf(rule.lipschitz) && std::isinf(rule.second_derivative);
        const bool stiff = first && *first > 0 && !by_values;
        if (!unknown && !stiff) return rule;
        rule.by = StepRule::By::first_order;
        rule.doubt = unknown ? why_unknown(leaf.value) : StepRule::Doubt::stiff;
        return rule;
    }

    StepRule of_bricks(std::size_t grid, graph::NodeId value) const {
        StepRule rule{.by = StepRule::By::bricks};
        const auto side = static_cast<std::size_t>(numbers_.bricks->side);
        const std::size_t count = side * side * side;
        for (std::size_t i = grid * count; i < (grid + 1) * count; ++i) {
            const float inverse = numbers_.bricks->texels[2 * i];
            const float second = numbers_.bricks->texels[2 * i + 1];
            if (second < 0) continue;
            ++rule.bricks;
            if (inverse >= 0) continue;
            ++rule.doubtful;
            const bool unknown = inverse > -1e-29F && second >= 1e30F;
            if (rule.doubt == StepRule::Doubt::none || unknown) {
                rule.doubt = unknown ? why_unknown(value) : StepRule::Doubt::stiff;
            }
        }
        if (rule.doubtful == 0 && document_.bounds.shape == scene::Bounds::Shape::none) {
            rule.doubt = StepRule::Doubt::endless;
        }
        return rule;
    }

    StepRule iteration(FieldId id) const {
        StepRule rule{.by = StepRule::By::estimate, .doubt = StepRule::Doubt::estimate};
        const double* inverse = number(FieldValue::What::inverse_lipschitz, id);
        if (inverse && *inverse > 0) rule.lipschitz = 1.0 / *inverse;
        return rule;
    }

    StepRule blend(FieldId id) const {
        StepRule rule{.by = StepRule::By::lipschitz};
        const double* inverse = number(FieldValue::What::inverse_lipschitz, id);
        if (inverse && *inverse > 0) {
            rule.lipschitz = 1.0 / *inverse;
        } else {
            rule.by = StepRule::By::blind;
            rule.doubt = document_.bounds.shape == scene::Bounds::Shape::none
                             ? StepRule::Doubt::endless
                             : StepRule::Doubt::unbounded;
        }
        const auto iterates = [&](FieldId leaf) {
            return std::holds_alternative<field::Iteration>(field_[leaf]);
        };
        if (std::ranges::any_of(leaves(field_, id), iterates)) {
            rule.doubt = StepRule::Doubt::estimate;
        }
        return rule;
    }

    /// By the operators that are there; what they are asked for was found to matter.
    StepRule::Doubt why_unknown(graph::NodeId value) const {
        if (document_.bounds.shape == scene::Bounds::Shape::none) return StepRule::Doubt::endless;
        bool jumps = false, partial = false;
        for (const graph::NodeId id : reachable(field_.graph, std::array{value})) {
            const Op op = field_.graph[id].op;
            jumps = jumps || may_jump(op);
            partial = partial || op == Op::div || op == Op::tan || op == Op::log || op == Op::pow ||
                      op == Op::sqrt || op == Op::asin || op == Op::acos;
        }
        return jumps     ? StepRule::Doubt::jumps
               : partial ? StepRule::Doubt::undefined
                         : StepRule::Doubt::unbounded;
    }

    const field::Field& field_;
    const shader::ProgramSource& source_;
    const shader::FieldNumbers& numbers_;
    const scene::Document& document_;
    std::vector<StepRule> rules_;
    int cells_ = 0;  ///< around the node
};

std::string_view words(StepRule::By by) {
    switch (by) {
        case StepRule::By::distance:
            return "the distance";
        case StepRule::By::second_derivative:
            return "a bound of the second derivative";
        case StepRule::By::lipschitz:
            return "a Lipschitz constant";
        case StepRule::By::polynomial:
            return "the polynomial along the ray";
        case StepRule::By::bricks:
            return "bounds brick by brick";
        case StepRule::By::intervals:
            return "intervals along the ray";
        case StepRule::By::estimate:
            return "the distance estimate";
        case StepRule::By::first_order:
            return "the first order";
        case StepRule::By::blind:
            return "parts of the region";
        case StepRule::By::tracer:
            break;
    }
    return "the tracer's own steps";
}

std::string_view words(StepRule::Doubt doubt) {
    switch (doubt) {
        case StepRule::Doubt::none:
            return "";
        case StepRule::Doubt::estimate:
            return "an estimate of an iteration";
        case StepRule::Doubt::undefined:
            return "a pole or the edge of a domain";
        case StepRule::Doubt::jumps:
            return "a jump";
        case StepRule::Doubt::unbounded:
            return "unbounded derivatives";
        case StepRule::Doubt::endless:
            return "no bounds of the region";
        case StepRule::Doubt::stiff:
            return "stiff";
        case StepRule::Doubt::chosen:
            break;
    }
    return "the tracer that was chosen";
}

/// The words of a doubt, and where it matters.
std::string reason(const StepRule& rule) {
    const std::string_view why = words(rule.doubt);
    if (rule.doubtful == 0) return std::string(why);
    return fmt::format("{} in {} of {} bricks", why, rule.doubtful, rule.bricks);
}

}  // namespace

std::vector<StepRule> step_rules(const field::Field& field, const shader::ProgramSource& source,
                                 const shader::FieldNumbers& numbers,
                                 const scene::Document& document) {
    return Rules(field, source, numbers, document).list();
}

std::string describe(const StepRule& rule) {
    if (!rule.proven()) return fmt::format("by {}: {}", words(rule.by), reason(rule));
    std::string text = fmt::format(
        "certified {}by {}", rule.within_rounding() ? "within rounding " : "", words(rule.by));
    if (rule.by == StepRule::By::second_derivative) {
        text += fmt::format(" ({:.4g})", rule.second_derivative);
    }
    if (rule.by == StepRule::By::lipschitz) text += fmt::format(" ({:.4g})", rule.lipschitz);
    return text;
}

std::string summary(std::span<const StepRule> rules) {
    const auto proven = std::ranges::count_if(rules, &StepRule::proven);
    if (proven == static_cast<std::ptrdiff_t>(rules.size())) {
        const bool rounded = std::ranges::any_of(rules, &StepRule::within_rounding);
        return rounded ? "certified within rounding" : "certified";
    }
    std::vector<std::string> reasons;
    for (const StepRule& rule : rules) {
        const std::string why = reason(rule);
        if (!rule.proven() && std::ranges::count(reasons, why) == 0) reasons.push_back(why);
    }
    std::string text =
        proven == 0 ? "heuristic: " : fmt::format("{} of {} certified; ", proven, rules.size());
    for (std::size_t i = 0; i < reasons.size(); ++i) {
        text += (i > 0 ? ", " : "");
        text += reasons[i];
    }
    return text;
}

}  // namespace compile
