// SPDX-License-Identifier: MIT
#include "render_answers/flat_field.h"

#include <array>
#include <cmath>
#include <limits>

#include "field/overloaded.h"
#include "graph/substitute.h"

namespace render_answers {
namespace {

using field::FieldId;
using graph::NodeId;
using graph::Op;

NodeId flat(field::Field& f, FieldId id) {
    graph::Graph& g = f.graph;
    const auto replaced =
        [&](NodeId root, const std::vector<std::pair<graph::VariableId, NodeId>>& replacements) {
            return graph::substitute(g, std::array{root}, replacements)[0];
        };
    const field::Node node = f[id];
    return std::visit(
        field::Overloaded{
            [&](const field::Formula& n) { return n.value; },
            [&](const field::Iteration&) { return g.constant(std::nan("")); },
            [&](const field::Union& n) { return g.apply(Op::min, flat(f, n.a), flat(f, n.b)); },
            [&](const field::Intersection& n) {
                return g.apply(Op::max, flat(f, n.a), flat(f, n.b));
            },
            [&](const field::Complement& n) { return g.apply(Op::neg, flat(f, n.a)); },
            [&](const field::Choice& n) {
                return g.apply(Op::select_less, n.less, n.than, flat(f, n.a), flat(f, n.b));
            },
            [&](const field::Blend& n) {
                std::vector<std::pair<graph::VariableId, NodeId>> replacements;
                for (std::size_t i = 0; i < n.operands.size(); ++i) {
                    replacements.emplace_back(n.values[i], flat(f, n.operands[i]));
                }
                const NodeId value = replaced(n.value, replacements);
                return n.displacement ? g.apply(Op::add, value, *n.displacement) : value;
            },
            [&](const field::Cells& n) {
                return replaced(flat(f, n.a), {{graph::variable_x, n.point[0]},
                                               {graph::variable_y, n.point[1]},
                                               {graph::variable_z, n.point[2]}});
            },
        },
        node);
}

}  // namespace

FlatField::FlatField(const field::Field& field, const std::vector<double>& parameters) {
    field::Field copy = field;
    const NodeId root = flat(copy, copy.root);
    tape_ = eval::make_tape(copy.graph, std::array{root});
    eval::load_parameters<double>(tape_, parameters, registers_);
}

double FlatField::operator()(glm::dvec3 point) {
    double value = 0;
    eval::evaluate_loaded<double>(tape_, std::array{point.x, point.y, point.z},
                                  std::span(&value, 1), registers_);
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
}

}  // namespace render_answers
