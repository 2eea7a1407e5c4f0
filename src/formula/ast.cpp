// SPDX-License-Identifier: MIT
#include "formula/ast.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace formula {
namespace {

struct Parts {
    using List = std::vector<ExpressionId>;

    List operator()(const Number&) const { return {}; }
    List operator()(const Name&) const { return {}; }
    List operator()(const Broken&) const { return {}; }
    List operator()(const Negate& negate) const { return {negate.operand}; }
    List operator()(const Power& power) const { return {power.base, power.exponent}; }
    List operator()(const Comparison& comparison) const {
        return {comparison.left, comparison.right};
    }
    List operator()(const Call& call) const { return call.arguments; }
    List operator()(const Tuple& tuple) const { return tuple.parts; }
    List operator()(const Component& component) const { return {component.operand}; }
    List operator()(const Iterate& it) const {
        List list;
        for (const Assignment& assignment : it.state) list.push_back(assignment.value);
        list.push_back(it.limit);
        if (it.until) list.push_back(*it.until);
        for (const Assignment& assignment : it.body) list.push_back(assignment.value);
        if (it.distance) list.push_back(*it.distance);
        if (it.colour) list.push_back(*it.colour);
        return list;
    }
    List operator()(const Sum& sum) const { return of(sum.operands); }
    List operator()(const Product& product) const { return of(product.operands); }
    List operator()(const Intersection& chain) const { return of(chain.operands); }
    List operator()(const Union& chain) const { return of(chain.operands); }

    static List of(const std::vector<Operand>& operands) {
        List list;
        for (const Operand& operand : operands) list.push_back(operand.expression);
        return list;
    }
};

}  // namespace

std::string_view spelling(Relation relation) {
    switch (relation) {
        case Relation::equal:
            return "=";
        case Relation::less_equal:
            return "<=";
        case Relation::less:
            return "<";
        case Relation::greater_equal:
            return ">=";
        case Relation::greater:
            return ">";
    }
    return "";
}

std::string_view spelling(ParameterType type) {
    switch (type) {
        case ParameterType::real:
            return "real";
        case ParameterType::integer:
            return "integer";
        case ParameterType::logarithmic:
            return "logarithmic";
        case ParameterType::angle:
            return "angle";
        case ParameterType::colour:
            return "colour";
        case ParameterType::choice:
            return "choice";
        case ParameterType::toggle:
            return "toggle";
    }
    return "";
}

std::vector<ExpressionId> parts(const ExpressionNode& node) { return std::visit(Parts{}, node); }

ExpressionId Program::add(ExpressionNode node, base::SourceSpan span) {
    std::uint32_t height = 0;
    for (const ExpressionId part : parts(node)) {
        assert(index(part) < expressions.size());
        height = std::max(height, (*this)[part].height);
    }
    expressions.push_back({std::move(node), span, height + 1});
    return static_cast<ExpressionId>(expressions.size() - 1);
}

}  // namespace formula
