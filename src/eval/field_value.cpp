// SPDX-License-Identifier: MIT
#include "eval/field_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "eval/tape.h"
#include "numeric/real.h"

namespace eval {
namespace {

/// What a point of one field is evaluated with.
struct Place {
    const field::Field& field;
    glm::dvec3 point;
    std::vector<double> parameters;
};

/// Outside the domain of a solid is outside.
double solid(double value) { return std::isnan(value) ? numeric::infinity : value; }

double value_at(const Place& place, field::FieldId id);

/// x, y and z, and room for all others.
std::vector<double> variables_at(const Place& place) {
    std::vector<double> variables(place.field.graph.variable_count(), 0.0);
    for (int i = 0; i < 3; ++i) variables[static_cast<std::size_t>(i)] = place.point[i];
    return variables;
}

std::vector<double> run(const Place& place, std::span<const graph::NodeId> roots,
                        const std::vector<double>& variables) {
    std::vector<double> results(roots.size()), scratch;
    evaluate<double>(make_tape(place.field.graph, roots), variables, place.parameters, results,
                     scratch);
    return results;
}

/// Once around the loop: the step for all state variables at once, from the old state.
void set_state(const field::Iteration& iteration, const std::vector<double>& values,
               std::vector<double>& variables) {
    for (std::size_t i = 0; i < iteration.state.size(); ++i) {
        variables[graph::index(iteration.state[i])] = values[i];
    }
}

/// Where an iteration ends: the point and the last state, indexed by VariableId.
struct LastTurn {
    std::vector<double> variables;
    bool escaped = false;
};

LastTurn iterate(const Place& place, const field::Iteration& iteration) {
    std::vector<double> variables = variables_at(place);
    set_state(iteration, run(place, iteration.start, variables), variables);

    const Tape step = make_tape(place.field.graph, iteration.step);
    std::vector<double> scratch, state(iteration.state.size());
    const double limit = std::round(run(place, std::array{iteration.limit}, variables)[0]);
    const auto escaped = [&] {
        return iteration.escape && run(place, std::array{*iteration.escape}, variables)[0] > 0;
    };
    bool out = escaped();
    for (double i = 0; i < limit && !out; ++i) {
        evaluate<double>(step, variables, place.parameters, state, scratch);
        set_state(iteration, state, variables);
        out = escaped();
    }
    return {std::move(variables), out};
}

double leaf(const Place& place, const field::Iteration& iteration) {
    const LastTurn last = iterate(place, iteration);
    if (iteration.escape && !last.escaped) return -numeric::infinity;
    return solid(run(place, std::array{iteration.distance}, last.variables)[0]);
}

double leaf(const Place& place, const field::Formula& formula) {
    const double value = evaluate(place.field.graph, formula.value, place.point, place.parameters);
    return formula.kind == field::Kind::solid ? solid(value) : value;
}

/// Blends calculate with their operands' values: far away instead of infinite.
double operand(double value) {
    return std::clamp(solid(value), -field::unknown_depth, field::unknown_depth);
}

double blend(const Place& place, const field::Blend& node) {
    std::vector<double> variables = variables_at(place);
    for (std::size_t i = 0; i < node.operands.size(); ++i) {
        variables[graph::index(node.values[i])] = operand(value_at(place, node.operands[i]));
    }
    const double value = run(place, std::array{node.value}, variables)[0];
    if (!node.displacement) return value;
    return value + solid(run(place, std::array{*node.displacement}, variables)[0]);
}

double in_cell(const Place& place, const field::Cells& node) {
    const std::vector<double> q = run(place, node.point, variables_at(place));
    return value_at({place.field, {q[0], q[1], q[2]}, place.parameters}, node.a);
}

bool first_chosen(const Place& place, const field::Choice& node) {
    const std::vector<double> sides =
        run(place, std::array{node.less, node.than}, variables_at(place));
    return sides[0] < sides[1];
}

double value_at(const Place& place, field::FieldId id) {
    struct Visitor {
        const Place& place;
        double operator()(const field::Formula& node) const { return leaf(place, node); }
        double operator()(const field::Iteration& node) const { return leaf(place, node); }
        double operator()(const field::Union& node) const {
            return numeric::min(value_at(place, node.a), value_at(place, node.b));
        }
        double operator()(const field::Intersection& node) const {
            return numeric::max(value_at(place, node.a), value_at(place, node.b));
        }
        double operator()(const field::Complement& node) const { return -value_at(place, node.a); }
        double operator()(const field::Blend& node) const { return blend(place, node); }
        double operator()(const field::Choice& node) const {
            return value_at(place, first_chosen(place, node) ? node.a : node.b);
        }
        double operator()(const field::Cells& node) const { return in_cell(place, node); }
    };
    return std::visit(Visitor{place}, place.field[id]);
}

Place place_of(const field::Field& field, glm::dvec3 point, std::span<const double> parameters) {
    Place place{field, point, {parameters.begin(), parameters.end()}};
    if (place.parameters.size() < field.graph.parameter_count()) {
        place.parameters.resize(field.graph.parameter_count(), 0.0);
    }
    return place;
}

}  // namespace

double value(const field::Field& field, field::FieldId id, glm::dvec3 point,
             std::span<const double> parameters) {
    return value_at(place_of(field, point, parameters), id);
}

std::optional<glm::dvec3> colour(const field::Field& field, field::FieldId leaf, glm::dvec3 point,
                                 std::span<const double> parameters) {
    const std::optional<field::Colour> colour = field::colour_of(field[leaf]);
    if (!colour) return std::nullopt;
    const Place place = place_of(field, point, parameters);
    std::vector<double> variables{point.x, point.y, point.z};
    if (const auto* iteration = std::get_if<field::Iteration>(&field[leaf])) {
        variables = iterate(place, *iteration).variables;
    }
    const std::vector<double> parts = run(place, *colour, variables);
    glm::dvec3 result(0);
    for (int i = 0; i < 3; ++i) {
        const double part = parts[static_cast<std::size_t>(i)];
        result[i] = part > 0 ? part : 0;
    }
    return result;
}

}  // namespace eval
