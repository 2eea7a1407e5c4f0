// SPDX-License-Identifier: MIT
#include "oracle/wide_field.h"

#include <cmath>

#include "field/overloaded.h"

namespace oracle {
namespace {

using field::FieldId;
using graph::NodeId;

Extended outside_if_undefined(const Extended& value) {
    return value.is_nan() ? Extended(numeric::infinity) : value;
}

bool is_inside(const Extended& value) { return value.number <= 0; }

}  // namespace

WideField::WideField(const field::Field& field, std::vector<double> parameters)
    : field_(field), variables_(field.graph.variable_count()), values_(field.graph.size()) {
    parameters.resize(field.graph.parameter_count(), 0.0);
    for (const double parameter : parameters) parameters_.push_back(parameter);
}

void WideField::take(const Point& point) {
    std::copy(point.begin(), point.end(), variables_.begin());
}

Extended WideField::number(NodeId root, const Point& point) {
    take(point);
    auto& order = orders_[root];
    if (order.empty()) order = reachable(field_.graph, std::array{root});
    for (const NodeId id : order) {
        const graph::Node& node = field_.graph[id];
        arguments_.clear();
        for (const NodeId each : node.args()) arguments_.push_back(values_[index(each)]);
        Extended& value = values_[index(id)];
        if (node.op == graph::Op::constant) value = node.value;
        if (node.op == graph::Op::variable) value = variables_[node.symbol];
        if (node.op == graph::Op::parameter) value = parameters_[node.symbol];
        if (!arguments_.empty()) value = eval::apply_by_type(node.op, arguments_);
    }
    return values_[index(root)];
}

Extended WideField::iterate(const field::Iteration& node, const Point& point) {
    const auto set = [&](const std::vector<NodeId>& roots) {
        std::vector<Extended> state;
        for (const NodeId root : roots) state.push_back(number(root, point));
        for (std::size_t i = 0; i < state.size(); ++i) variables_[index(node.state[i])] = state[i];
    };
    // Of a set that is escaped from only the side.
    const auto escaped = [&] { return node.escape && number(*node.escape, point).number > 0; };
    set(node.start);
    if (escaped()) return 1.0;
    const long double limit = std::round(number(node.limit, point).number);
    for (long double turn = 0; turn < limit; ++turn) {
        set(node.step);
        if (escaped()) return 1.0;
    }
    if (node.escape) return -1.0;
    return outside_if_undefined(number(node.distance, point));
}

WideField::Content WideField::content(FieldId id, const Point& point) {
    return std::visit(
        field::Overloaded{
            [&](const field::Formula& node) -> Content {
                const Extended value = number(node.value, point);
                if (node.kind == field::Kind::solid) return {outside_if_undefined(value), {}};
                return {numeric::infinity, {{value}}};
            },
            [&](const field::Iteration& node) -> Content {
                return {iterate(node, point), {}};
            },
            [&](const field::Union& node) {
                Content a = content(node.a, point);
                const Content b = content(node.b, point);
                a.solid = min(a.solid, b.solid);
                a.sheets.insert(a.sheets.end(), b.sheets.begin(), b.sheets.end());
                return a;
            },
            [&](const field::Intersection& node) {
                Content a = content(node.a, point), b = content(node.b, point);
                for (Sheet& sheet : a.sheets) sheet.kept = sheet.kept && is_inside(b.solid);
                for (Sheet& sheet : b.sheets) sheet.kept = sheet.kept && is_inside(a.solid);
                a.solid = max(a.solid, b.solid);
                a.sheets.insert(a.sheets.end(), b.sheets.begin(), b.sheets.end());
                return a;
            },
            [&](const field::Complement& node) -> Content {
                return {-solid(node.a, point), {}};
            },
            [&](const field::Choice& node) {
                const bool first =
                    number(node.less, point).number < number(node.than, point).number;
                return content(first ? node.a : node.b, point);
            },
            [&](const field::Blend& node) -> Content {
                std::vector<Extended> operands;
                for (const FieldId operand : node.operands) {
                    const Extended far = field::unknown_depth;
                    operands.push_back(max(-far, min(far, solid(operand, point))));
                }
                for (std::size_t i = 0; i < operands.size(); ++i) {
                    variables_[index(node.values[i])] = operands[i];
                }
                const Extended value = outside_if_undefined(number(node.value, point));
                if (!node.displacement) return {value, {}};
                return {value + outside_if_undefined(number(*node.displacement, point)), {}};
            },
            [&](const field::Cells& node) {
                Point inside;
                for (std::size_t i = 0; i < 3; ++i) inside[i] = number(node.point[i], point);
                return content(node.a, inside);
            },
        },
        field_[id]);
}

}  // namespace oracle
