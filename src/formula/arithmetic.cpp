// SPDX-License-Identifier: MIT
#include "formula/arithmetic.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "formula/orbit.h"
#include "formula/products.h"
#include "formula/vector.h"

namespace formula {
namespace {

using graph::Expr;
using graph::NodeId;
using graph::Op;

Op operator_of(Joint joint) {
    switch (joint) {
        case Joint::plus:
            return Op::add;
        case Joint::minus:
            return Op::sub;
        case Joint::times:
        case Joint::implied_times:
            return Op::mul;
        case Joint::over:
            return Op::div;
        case Joint::both:
        case Joint::without:
        case Joint::either:
            break;
    }
    assert(false);
    return Op::add;
}

bool has_real_part(const VectorValue& value) {
    return value.algebra == Algebra::complex || value.algebra == Algebra::quaternion;
}

std::string_view verb(Joint joint) { return joint == Joint::minus ? "subtracted" : "added"; }

Value mismatch(Lowering& lowering, base::SourceSpan span, std::string message) {
    lowering.error(span, std::move(message));
    return Nothing{};
}

Value add_vectors(Lowering& lowering, Joint joint, base::SourceSpan span, const VectorValue& a,
                  const VectorValue& b) {
    const std::optional<Algebra> algebra = common_algebra(a, b);
    if (!algebra) {
        return mismatch(lowering, span,
                        fmt::format("{} and {} cannot be {}; both need the same number of "
                                    "components",
                                    describe(a), describe(b), verb(joint)));
    }
    graph::Graph& graph = lowering.field.graph;
    const Components left = components(graph, a.components),
                     right = components(graph, b.components);
    return VectorValue{*algebra, nodes(joint == Joint::plus ? left + right : left - right),
                       orbit_of_sum(lowering, a, b)};
}

/// A number goes to the real part.
Value add_number(Lowering& lowering, Joint joint, base::SourceSpan span, const Value& a,
                 const Value& b) {
    const bool left = std::holds_alternative<NodeId>(a);
    const NodeId number = std::get<NodeId>(left ? a : b);
    const VectorValue& vector = std::get<VectorValue>(left ? b : a);
    if (!has_real_part(vector)) {
        return mismatch(lowering, span,
                        fmt::format("{} and {} cannot be {}; write a vector for the number too",
                                    describe(a), describe(b), verb(joint)));
    }
    graph::Graph& graph = lowering.field.graph;
    VectorValue result = vector;
    if (left && joint == Joint::minus) {
        result.components = nodes(-components(graph, vector.components));
    }
    const NodeId real = vector.components[0];
    result.components[0] = left ? graph.apply(operator_of(joint), number, real)
                                : graph.apply(operator_of(joint), real, number);
    const NodeId zero = graph.constant(0);
    VectorValue constant{vector.algebra, std::vector<NodeId>(vector.components.size(), zero)};
    constant.components[0] = number;
    result.orbit = orbit_of_sum(lowering, vector, constant);
    return result;
}

Value multiple(Lowering& lowering, NodeId number, const VectorValue& v, bool number_first) {
    graph::Graph& graph = lowering.field.graph;
    const Components parts = components(graph, v.components);
    const Expr factor(graph, number);
    return VectorValue{v.algebra, nodes(number_first ? factor * parts : parts * factor),
                       orbit_of_multiple(lowering, number, v)};
}

}  // namespace

std::optional<Algebra> common_algebra(const VectorValue& a, const VectorValue& b) {
    if (a.components.size() != b.components.size()) return std::nullopt;
    if (a.algebra == b.algebra || b.algebra == Algebra::vector) return a.algebra;
    if (a.algebra == Algebra::vector) return b.algebra;
    return std::nullopt;
}

std::string_view constructor(Algebra algebra) {
    switch (algebra) {
        case Algebra::vector:
            return "vector";
        case Algebra::complex:
            return "complex";
        case Algebra::quaternion:
            return "quaternion";
        case Algebra::triplex:
            return "triplex";
    }
    return "";
}

Value negative(Lowering& lowering, const Value& a) {
    graph::Graph& graph = lowering.field.graph;
    if (const auto* number = std::get_if<NodeId>(&a)) return graph.apply(Op::neg, *number);
    const VectorValue& vector = std::get<VectorValue>(a);
    return VectorValue{vector.algebra, nodes(-components(graph, vector.components)), vector.orbit};
}

Value combine(Lowering& lowering, Joint joint, base::SourceSpan span, const Value& a,
              const Value& b) {
    const auto* left = std::get_if<NodeId>(&a);
    const auto* right = std::get_if<NodeId>(&b);
    graph::Graph& graph = lowering.field.graph;
    if (left && right) return graph.apply(operator_of(joint), *left, *right);
    if (joint == Joint::plus || joint == Joint::minus) {
        if (left || right) return add_number(lowering, joint, span, a, b);
        return add_vectors(lowering, joint, span, std::get<VectorValue>(a),
                           std::get<VectorValue>(b));
    }
    if (joint == Joint::over) {
        if (!right) return quotient(lowering, span, a, std::get<VectorValue>(b));
        const VectorValue& vector = std::get<VectorValue>(a);
        return VectorValue{vector.algebra,
                           nodes(components(graph, vector.components) / Expr(graph, *right)),
                           orbit_of_fraction(lowering, vector, *right)};
    }
    if (left) return multiple(lowering, *left, std::get<VectorValue>(b), true);
    if (right) return multiple(lowering, *right, std::get<VectorValue>(a), false);
    return product(lowering, span, std::get<VectorValue>(a), std::get<VectorValue>(b));
}

Value raise(Lowering& lowering, base::SourceSpan span, const Value& a, const Value& b) {
    const auto* exponent = std::get_if<NodeId>(&b);
    if (!exponent) {
        return mismatch(lowering, span,
                        fmt::format("an exponent is a number, not {}", describe(b)));
    }
    if (const auto* number = std::get_if<NodeId>(&a)) {
        return lowering.field.graph.apply(Op::pow, *number, *exponent);
    }
    return power(lowering, span, std::get<VectorValue>(a), *exponent);
}

}  // namespace formula
