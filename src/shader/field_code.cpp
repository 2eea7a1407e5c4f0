// SPDX-License-Identifier: MIT
#include "shader/field_code.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "analysis/running_error.h"
#include "passes/differentiate.h"
#include "passes/jump_walls.h"
#include "passes/operation_count.h"
#include "passes/pipeline.h"
#include "passes/polynomial_along.h"
#include "passes/rewrite.h"
#include "passes/spell_out_lengths.h"
#include "shader/domain.h"

namespace shader {

using field::FieldId;

FieldCode::FieldCode(field::Field of, const Demands& demanded, Precision precision)
    : field(std::move(of)), demands(demanded), values(precision) {
    // Members have neither intervals nor Hessians of their own.
    const bool as_data = !demands.intervals && !demands.hessians && !demands.text_only;
    if (as_data) gathered = gather_families(field);
    plan = field_plan(field, gathered);
    if (as_data) {
        code_families();
        code_minima();
    }
    differentiate_orbits();
    spell_out_orbits();
    differentiate();
    if (demands.hessians) differentiate_twice();
    if (demands.polynomials) find_coefficients();
    make_cheap();
    if (!edges && !breaks) bound_rounding();
    depends = depends_on_variables(field.graph);
    nan = may_be_nan(field);
}

/// Escape, power and running derivative share the squares of an orbit's length.
void FieldCode::spell_out_orbits() {
    std::vector<graph::NodeId*> places;
    for (field::Node& node : field.nodes) {
        auto* iteration = std::get_if<field::Iteration>(&node);
        if (!iteration) continue;
        for (graph::NodeId& id : iteration->start) places.push_back(&id);
        for (graph::NodeId& id : iteration->step) places.push_back(&id);
        if (iteration->escape) places.push_back(&*iteration->escape);
        places.push_back(&iteration->distance);
    }
    std::vector<graph::NodeId> roots;
    for (const graph::NodeId* place : places) roots.push_back(*place);
    const std::vector<graph::NodeId> spelt =
        passes::rewrite(field.graph, roots, passes::spell_out_lengths);
    for (std::size_t i = 0; i < places.size(); ++i) *places[i] = spelt[i];
}

namespace {

/// The same with lengths as roots of sums of squares: faster on the CPU, where nothing overflows
/// that can be seen.
graph::NodeId with_roots(graph::Graph& graph, graph::NodeId root) {
    std::map<graph::NodeId, graph::NodeId> copies;
    for (const graph::NodeId id : reachable(graph, std::array{root})) {
        const graph::Node node = graph[id];  // a copy: adding nodes moves them
        std::array<graph::NodeId, graph::max_arity> arguments{};
        const std::size_t count = node.args().size();
        for (std::size_t i = 0; i < count; ++i) arguments[i] = copies.at(node.arguments[i]);
        if (count == 0) {
            copies[id] = id;
        } else if (node.op == graph::Op::hypot || node.op == graph::Op::hypot3) {
            const auto square = [&](std::size_t i) {
                return graph.apply(graph::Op::mul, arguments[i], arguments[i]);
            };
            graph::NodeId sum = square(0);
            for (std::size_t i = 1; i < count; ++i) {
                sum = graph.apply(graph::Op::add, sum, square(i));
            }
            copies[id] = graph.apply(graph::Op::sqrt, sum);
        } else {
            copies[id] = graph.apply(node.op, std::span(arguments).first(count));
        }
    }
    return copies.at(root);
}

}  // namespace

void FieldCode::code_family(Family of, const std::vector<FieldId>& cells, std::size_t first_object,
                            bool tells_objects) {
    CodedFamily family;
    family.tells_objects = tells_objects;
    family.it = std::move(of);
    family.first_object = first_object;
    family.cells = cells;
    std::vector<graph::NodeId> values;
    std::size_t numbers = 0;
    for (const MemberKind& kind : family.it.kinds) {
        values.push_back(kind.value);
        family.tapes.push_back(
            {eval::make_tape(field.graph, std::array{with_roots(field.graph, kind.value)}),
             kind.variables});
        numbers = std::max(numbers, kind.variables.size());
    }
    numbers += (values.size() > 1 ? 1 : 0) + (tells_objects ? 1 : 0);
    family.texels = std::max<std::size_t>((numbers + 3) / 4, 1);
    family.gradients = passes::gradients(field.graph, values);
    families.push_back(std::move(family));
}

void FieldCode::code_families() {
    for (const PlannedFamily& planned : plan.families) {
        // Within cells of copies ways are short.
        trees.push_back({{.first = families.size(),
                          .may_be_far = planned.cells.empty(),
                          .cells = planned.cells}});
        code_family(gathered.at(planned.id), planned.cells, planned.first_object, true);
    }
}

/// Formulas of many operands are written by their outlines.
void FieldCode::code_minima() {
    const std::vector<bool> depends_on_point = depends_on_variables(field.graph);
    std::map<FieldId, std::vector<field::Minimum>> known;
    for (std::size_t i = 0; i < plan.objects.size(); ++i) {
        const Object& object = plan.objects[i];
        auto* leaf = std::get_if<field::Formula>(&field.nodes[index(object.id)]);
        if (!leaf || object.is_member || leaf->minima.empty()) continue;
        std::vector<Family> found;
        for (const field::Minimum& minimum : leaf->minima) {
            auto family = family_of(field, depends_on_point, minimum);
            if (family) found.push_back(*std::move(family));
        }
        if (found.size() < leaf->minima.size()) continue;
        // A blend of values needs more than a bound.
        trees.push_back({{.first = families.size(),
                          .count = found.size(),
                          .outline = eval::make_tape(field.graph, std::array{leaf->outline}),
                          .may_be_far = is_distance(i) && !object.blend && object.cells.empty(),
                          .cells = object.cells}});
        for (std::size_t k = 0; k < found.size(); ++k) {
            minima[i][leaf->minima[k].variable] = families.size();
            code_family(std::move(found[k]), object.cells, i, false);
            families.back().variable = leaf->minima[k].variable;
        }
        leaf->value = leaf->outline;
    }
    for (field::Node& node : field.nodes) {
        // What the outline is made of is in the families now.
        if (auto* leaf = std::get_if<field::Formula>(&node)) leaf->minima.clear();
    }
}

void FieldCode::differentiate() {
    std::vector<FieldId> formulas;
    std::vector<graph::NodeId> formula_values;
    for (const Object& object : plan.objects) {
        if (object.is_member) continue;
        if (const auto* leaf = std::get_if<field::Formula>(&field[object.id])) {
            formulas.push_back(object.id);
            formula_values.push_back(leaf->value);
        }
    }
    for (const auto& [object, variables] : minima) {
        const FieldId id = plan.objects[object].id;
        const graph::NodeId value = formula(object)->value;
        for (const auto& [variable, number] : variables) {
            const graph::NodeId weight = passes::differentiate(field.graph, value, variable);
            minima_weights[id][variable] = passes::run(field.graph, std::array{weight})[0];
        }
    }
    edges = may_be_undefined(field.graph, formula_values);
    // A minimum has kinks where the nearest operand changes.
    breaks = !minima.empty() || may_break(field.graph, formula_values);
    const auto found = passes::gradients(field.graph, formula_values);
    for (std::size_t i = 0; i < formulas.size(); ++i) gradients[formulas[i]] = found[i];
    for (std::size_t i = 0; i < formulas.size(); ++i) {
        auto walls = passes::jump_walls(field.graph, formula_values[i]);
        if (walls.empty()) continue;
        jump_rates[formulas[i]] = passes::gradients(field.graph, walls);
        jump_walls[formulas[i]] = std::move(walls);
    }
    for (const FieldId id : plan.cells) {
        const auto& cells = std::get<field::Cells>(field[id]);
        const auto turn = passes::gradients(field.graph, cells.point);
        std::ranges::copy(turn, turns[id].begin());
        wall_rates[id] = passes::gradients(field.graph, cells.walls);
    }
    for (const FieldId id : plan.mixes) {
        const auto& blend = std::get<field::Blend>(field[id]);
        for (const graph::VariableId by : blend.values) {
            const graph::NodeId weight = passes::differentiate(field.graph, blend.value, by);
            weights[id].push_back(passes::run(field.graph, std::array{weight})[0]);
        }
        if (!blend.displacement) continue;
        displacements[id] = passes::gradient(field.graph, *blend.displacement);
    }
}

void FieldCode::differentiate_twice() {
    for (std::size_t i = 0; i < plan.objects.size(); ++i) {
        const Object& object = plan.objects[i];
        if (!formula(i) || is_distance(i) || object.blend || object.is_member) continue;
        const auto rows = passes::gradients(field.graph, gradients.at(object.id));
        hessians[object.id] = {rows[0][0], rows[1][1], rows[2][2],
                               rows[0][1], rows[0][2], rows[1][2]};
    }
}

/// Of leaves that are asked at points of the ray itself. Coefficients live as long as the ray:
/// where there are many leaves they would fill the registers and are not worth it.
void FieldCode::find_coefficients() {
    constexpr std::size_t least_degree = 3, largest_degree = 12, most_leaves = 16,
                          most_evaluations = 8;
    std::vector<std::size_t> leaves;
    for (std::size_t i = 0; i < plan.objects.size(); ++i) {
        const Object& object = plan.objects[i];
        if (!formula(i) || is_distance(i) || object.blend || !object.cells.empty()) continue;
        if (minima.contains(i)) continue;
        leaves.push_back(i);
    }
    if (leaves.size() > most_leaves) return;
    std::array<graph::NodeId, 6> nodes{};
    for (std::size_t i = 0; i < 6; ++i) {
        ray[i] = field.graph.new_variable(std::string(i < 3 ? "c" : "e") + "xyz"[i % 3]);
        nodes[i] = field.graph.variable(ray[i]);
    }
    const std::array point{nodes[0], nodes[1], nodes[2]}, vector{nodes[3], nodes[4], nodes[5]};
    const auto operations = [&](std::span<const graph::NodeId> roots) {
        return passes::count_operations(field.graph, roots).multiplied_out;
    };
    for (const std::size_t i : leaves) {
        const graph::NodeId f = formula(i)->value;
        auto found = passes::polynomial_along(field.graph, f, point, vector, largest_degree);
        if (!found || found->size() <= least_degree) continue;
        const Gradient& g = gradients.at(plan.objects[i].id);
        const std::size_t evaluation = operations(std::array{f, g[0], g[1], g[2]});
        if (operations(*found) <= most_evaluations * evaluation) along[i] = std::move(*found);
    }
}

/// The last passes see values and derivatives together, which share much.
void FieldCode::make_cheap() {
    std::vector<graph::NodeId*> places = passes::all_expressions(field);
    const auto add = [&](auto& slopes) {
        for (graph::NodeId& slope : slopes) places.push_back(&slope);
    };
    for (auto& [id, gradient] : gradients) add(gradient);
    for (auto& [id, gradient] : orbit_gradients) add(gradient);
    for (auto& [id, hessian] : hessians) add(hessian);
    for (auto& [id, rows] : turns) std::ranges::for_each(rows, add);
    for (auto& [id, rates] : wall_rates) std::ranges::for_each(rates, add);
    for (auto& [id, rates] : jump_rates) std::ranges::for_each(rates, add);
    for (auto& [id, walls] : jump_walls) add(walls);
    for (auto& [id, gradient] : displacements) add(gradient);
    for (auto& [id, list] : minima_weights) {
        for (auto& [variable, weight] : list) places.push_back(&weight);
    }
    for (CodedFamily& family : families) {
        std::ranges::for_each(family.gradients, add);
        for (MemberKind& kind : family.it.kinds) {
            places.push_back(&kind.value);
            if (kind.colour) add(*kind.colour);
        }
    }
    for (auto& [id, list] : weights) {
        for (graph::NodeId& weight : list) places.push_back(&weight);
    }
    std::vector<graph::NodeId> roots;
    for (const graph::NodeId* place : places) roots.push_back(*place);
    const std::vector<graph::NodeId> cheap =
        passes::run(field.graph, roots, passes::Stage::evaluation);
    for (std::size_t i = 0; i < places.size(); ++i) *places[i] = cheap[i];
}

/// Of the expressions as they are evaluated.
void FieldCode::bound_rounding() {
    // Our functions in double are as exact in proportion.
    const double part = values.precision() == Precision::doubled ? 4e-8 : 1;
    position_error = field.graph.new_variable("off");
    const graph::NodeId position = field.graph.variable(position_error);
    std::vector<graph::NodeId> formulas;
    for (const auto& [id, gradient] : gradients) {
        formulas.push_back(std::get<field::Formula>(field[id]).value);
    }
    const auto bounds = analysis::running_errors(field.graph, formulas, position, part);
    std::vector<FieldId> known;
    std::vector<graph::NodeId> errors;
    for (std::size_t i = 0; const auto& [id, gradient] : gradients) {
        const auto& bound = bounds[i++];
        if (!bound) continue;
        known.push_back(id);
        errors.push_back(*bound);
    }
    errors = passes::run(field.graph, errors, passes::Stage::evaluation);
    for (std::size_t i = 0; i < known.size(); ++i) rounding[known[i]] = errors[i];
}

std::optional<std::size_t> FieldCode::brick_grid(std::size_t object) const {
    const auto found = std::ranges::find(out.bricks, plan.objects[object].id);
    if (found == out.bricks.end()) return std::nullopt;
    return static_cast<std::size_t>(found - out.bricks.begin());
}

ExpressionWriter FieldCode::writer(const std::string& p) {
    return {field.graph,
            depends,
            values,
            {{graph::variable_x, p + ".x"},
             {graph::variable_y, p + ".y"},
             {graph::variable_z, p + ".z"}},
            &nan};
}

void FieldCode::finish(const ExpressionWriter& writer) {
    out.operator_parts.insert(writer.operator_parts().begin(), writer.operator_parts().end());
}

FamilyTable family_table(const FieldCode& code, const CodedFamily& family) {
    FamilyTable table;
    table.kinds = family.tapes;
    table.texels = family.texels;
    if (family.tells_objects) table.first_object = family.first_object;
    table.variable = family.variable;
    std::vector<graph::NodeId> numbers;
    for (const Member& member : family.it.members) {
        table.members.push_back(member.kind);
        table.sizes.push_back(member.numbers.size());
        numbers.insert(numbers.end(), member.numbers.begin(), member.numbers.end());
    }
    table.is_smooth = family.it.width.has_value();
    if (family.it.width) numbers.push_back(*family.it.width);
    table.numbers = eval::make_tape(code.field.graph, numbers);
    return table;
}

WayIn way_in(const FieldCode& code, const std::vector<FieldId>& cells, const std::string& indent) {
    WayIn way{"", {"p"}};
    if (cells.empty()) return way;
    way.statements = fmt::format("{}real3 e;\n{}real w;\n", indent, indent);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string q = fmt::format("q{}", i);
        way.statements +=
            fmt::format("{0}real3 {1};\n{0}cell_{2}({3}, real3(0.0), {1}, e, w);\n", indent, q,
                        code.plan.cells_number(cells[i]), way.points.back());
        way.points.push_back(q);
    }
    return way;
}

}  // namespace shader
