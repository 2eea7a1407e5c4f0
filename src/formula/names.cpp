// SPDX-License-Identifier: MIT
// Looking names up: definitions and parameters first, then what is built in.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "formula/built_in.h"
#include "formula/functions.h"
#include "formula/limits.h"
#include "formula/lowering.h"
#include "formula/mentions.h"
#include "formula/suggest.h"
#include "formula/user_function.h"

namespace formula {
namespace {

/// Where a later statement defines this name, if one does.
std::optional<base::SourceSpan> defined_later(const Lowering& lowering, std::string_view name) {
    for (const Statement& statement : lowering.source->program.statements) {
        const bool same = std::visit([&](const auto& it) { return it.name == name; }, statement);
        if (same) return std::visit([](const auto& it) { return it.span; }, statement);
    }
    return std::nullopt;
}

/// True for names such as `xy` or `xyz`, which are meant as products.
bool is_run_of_coordinates(std::string_view name) {
    return name.size() > 1 && name.size() < 5 &&
           name.find_first_not_of("xyz") == std::string_view::npos;
}

std::string spell_product(std::string_view name) {
    std::string product(1, name[0]);
    for (const char factor : name.substr(1)) (product += '*') += factor;
    return product;
}

/// True for names such as `x2`.
bool is_coordinate_and_number(std::string_view name) {
    return name.size() > 1 && is_coordinate(name.substr(0, 1)) &&
           name.substr(1).find_first_not_of("0123456789") == std::string_view::npos;
}

/// True if the last line is `name = ...`: a definition that nothing follows.
bool is_unfinished_definition(const Lowering& lowering, base::SourceSpan name) {
    const auto* last = std::get_if<Comparison>(&lowering[lowering.source->program.result].node);
    return last && last->relation == Relation::equal && lowering.span(last->left) == name;
}

/// `f → g → f` if the statement around a place needs itself through this name.
std::string path_to_itself(const Lowering& lowering, std::string_view name,
                           base::SourceSpan place) {
    const std::vector<Statement>& statements = lowering.source->program.statements;
    const auto after = std::ranges::find_if(statements, [&](const Statement& statement) {
        return std::visit([&](const auto& it) { return it.span.begin > place.begin; }, statement);
    });
    // Looking for cycles costs time, and further errors are not shown.
    if (after == statements.begin() || lowering.errors.size() > max_errors) return "";
    const auto from = static_cast<std::size_t>(after - statements.begin()) - 1;
    return fmt::format("{}", fmt::join(cycle(lowering.source->program, from, name), " → "));
}

/// What is wrong with a name that an iteration around its place knows, but not there.
std::string wrong_in_iteration(const Lowering& lowering, std::string_view name) {
    const Scope* scope = lowering.scope;
    while (scope && !scope->iteration) scope = scope->outer;
    if (!scope) return "";
    const Iterate& iterate = *scope->iteration;
    if (std::ranges::find(iterate.body, name, &Assignment::name) != iterate.body.end()) {
        return fmt::format(
            "'{0}' lasts for one turn only; to carry it along, give it an initial value: 'iterate "
            "{1} = …, {0} = …'",
            name, iterate.state[0].name);
    }
    if (name == "turns") {
        return "'turns' is known after the last turn, to 'distance' and 'colour'; before, 'i' is "
               "the number of turns";
    }
    if (name == "growth" || name == "smooth_turns") {
        return fmt::format("'{}' is known after the last turn, to 'distance' and 'colour'", name);
    }
    return "";
}

std::string hint(const Lowering& lowering, std::string_view name, base::SourceSpan span) {
    if (is_run_of_coordinates(name)) {
        return fmt::format("; write '{}' for a product", spell_product(name));
    }
    if (is_coordinate_and_number(name)) {
        return fmt::format("; write '{0}^{1}' for a power or '{0}*{1}' for a product", name[0],
                           name.substr(1));
    }
    std::vector<std::string_view> candidates = built_in_names();
    for (const Scope* scope = lowering.scope; scope; scope = scope->outer) {
        for (const auto& [known, binding] : scope->names) candidates.push_back(known);
    }
    const std::string_view meant = nearest(name, candidates);
    if (!meant.empty()) return fmt::format("; did you mean '{}'?", meant);
    if (is_unfinished_definition(lowering, span)) {
        return "; to define it, type an equation such as x^2 + y^2 + z^2 = 1 on the next line";
    }
    return "";
}

}  // namespace

bool report_function(Lowering& lowering, base::SourceSpan span, const Value& value) {
    const auto* function = std::get_if<FunctionValue>(&value);
    if (!function) return false;
    lowering.error(
        span, fmt::format("'{}' needs its arguments in brackets; it is called '{}'", function->name,
                          function->definition ? signature(*function) : signature(function->name)));
    return true;
}

void report_unknown_name(Lowering& lowering, std::string_view name, base::SourceSpan span) {
    const std::optional<base::SourceSpan> later = defined_later(lowering, name);
    if (later) {
        const std::string path = path_to_itself(lowering, name, span);
        lowering.error(
            span,
            path.empty()
                ? fmt::format("'{}' is defined further down, on line {}; move that line up", name,
                              lowering.line(*later))
                : fmt::format("a definition cannot use itself: {}; repeat with iterate", path));
        return;
    }
    std::string lost = wrong_in_iteration(lowering, name);
    lowering.error(span, lost.empty()
                             ? fmt::format("unknown name '{}'{}", name, hint(lowering, name, span))
                             : std::move(lost));
}

std::optional<graph::NodeId> built_in_number(Lowering& lowering, std::string_view name) {
    graph::Graph& graph = lowering.field.graph;
    if (name == "x") return graph.variable(graph::variable_x);
    if (name == "y") return graph.variable(graph::variable_y);
    if (name == "z") return graph.variable(graph::variable_z);
    if (name == "r") return radius(graph);
    if (name == "t") return graph.parameter(graph::parameter_t);
    if (name == "e") return graph.constant(std::numbers::e);
    if (name == "pi") return graph.constant(std::numbers::pi);
    if (name == "tau") return graph.constant(2 * std::numbers::pi);
    return std::nullopt;
}

Value lower_name(Lowering& lowering, std::string_view name, base::SourceSpan span) {
    if (Binding* found = find_binding(lowering.scope, name)) {
        found->used = true;
        return found->value;
    }
    if (const std::optional<graph::NodeId> number = built_in_number(lowering, name)) {
        return *number;
    }
    if (is_callable(name)) return FunctionValue{std::string(name)};
    report_unknown_name(lowering, name, span);
    return Nothing{};
}

}  // namespace formula
