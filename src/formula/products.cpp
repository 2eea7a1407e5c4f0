// SPDX-License-Identifier: MIT
#include "formula/products.h"

#include <fmt/format.h>

#include <cmath>

#include "formula/arithmetic.h"
#include "formula/complex.h"
#include "formula/limits.h"
#include "formula/orbit.h"
#include "formula/quaternion.h"
#include "formula/triplex.h"

namespace formula {
namespace {

using graph::Expr;
using graph::Graph;
using graph::NodeId;

Complex complex_of(Graph& graph, const VectorValue& v) {
    return {Expr(graph, v.components[0]), Expr(graph, v.components[1])};
}
Quaternion quaternion_of(Graph& graph, const VectorValue& v) {
    return {Expr(graph, v.components[0]), Expr(graph, v.components[1]),
            Expr(graph, v.components[2]), Expr(graph, v.components[3])};
}
Triplex triplex_of(Graph& graph, const VectorValue& v) {
    return {Expr(graph, v.components[0]), Expr(graph, v.components[1]),
            Expr(graph, v.components[2])};
}
VectorValue value(Complex z) { return {Algebra::complex, {z.re.id, z.im.id}}; }
VectorValue value(const Quaternion& q) {
    return {Algebra::quaternion, {q.a.id, q.b.id, q.c.id, q.d.id}};
}
VectorValue value(const Triplex& p) { return {Algebra::triplex, {p.x.id, p.y.id, p.z.id}}; }

VectorValue one(Graph& graph, const VectorValue& like) {
    VectorValue result{like.algebra,
                       std::vector<NodeId>(like.components.size(), graph.constant(0))};
    result.components[0] = graph.constant(1);
    return result;
}

bool is_multiplied(const VectorValue& v) {
    return v.algebra == Algebra::complex || v.algebra == Algebra::quaternion;
}

Value mismatch(Lowering& lowering, base::SourceSpan span, std::string message) {
    lowering.error(span, std::move(message));
    return Nothing{};
}

/// What to write instead of a product that does not exist.
std::string product_hint(const VectorValue& a, const VectorValue& b) {
    const VectorValue& known = a.algebra == Algebra::vector ? b : a;
    if (known.algebra == Algebra::triplex) return "triplex numbers have powers z^n only";
    if (known.algebra != Algebra::vector && common_algebra(a, b)) {
        return fmt::format("write {}(…) around the vector", constructor(known.algebra));
    }
    if (known.algebra != Algebra::vector) return "make both of one kind";
    if (a.components.size() == 3 && b.components.size() == 3) {
        return "write dot(a, b) or cross(a, b), or multiply the components";
    }
    return "write dot(a, b), or multiply the components";
}

/// The exponent if it is a whole number that is worth squaring for.
std::optional<int> whole(Lowering& lowering, NodeId exponent) {
    const std::optional<double> known = lowering.facts.constant(lowering.field.graph, exponent);
    if (!known || *known != std::floor(*known) || std::abs(*known) > max_squared_power) {
        return std::nullopt;
    }
    return static_cast<int>(*known);
}

VectorValue positive_power(Graph& graph, const VectorValue& a, int n) {
    if (n == 1) return a;
    switch (a.algebra) {
        case Algebra::complex:
            return value(whole_power(complex_of(graph, a), n));
        case Algebra::quaternion:
            return value(whole_power(quaternion_of(graph, a), n));
        case Algebra::triplex:
            return value(whole_power(triplex_of(graph, a), n));
        case Algebra::vector:
            break;
    }
    return a;
}

VectorValue power_by_angle(Graph& graph, const VectorValue& a, NodeId exponent) {
    const Expr n(graph, exponent);
    switch (a.algebra) {
        case Algebra::complex:
            return value(real_power(complex_of(graph, a), n));
        case Algebra::quaternion:
            return value(real_power(quaternion_of(graph, a), n));
        case Algebra::triplex:
            return value(real_power(triplex_of(graph, a), n));
        case Algebra::vector:
            break;
    }
    return a;
}

std::optional<Orbit> orbit_of_power(Lowering& lowering, const VectorValue& a, NodeId exponent,
                                    std::optional<int> n) {
    if (n == 1) return a.orbit;
    if (a.algebra != Algebra::triplex || !a.orbit) return orbit_of_power(lowering, a, exponent);
    Graph& graph = lowering.field.graph;
    const Triplex v = triplex_of(graph, a);
    const Expr around =
        n && *n > 1 ? whole_power_around(v, *n) : real_power_around(v, Expr(graph, exponent));
    return orbit_of_triplex_power(lowering, a, exponent, around);
}

VectorValue whole_power(Lowering& lowering, const VectorValue& a, int n) {
    Graph& graph = lowering.field.graph;
    if (n == 0) return one(graph, a);
    if (n > 0) return positive_power(graph, a, n);
    return *inverse(lowering, positive_power(graph, a, -n));
}

}  // namespace

Value product(Lowering& lowering, base::SourceSpan span, const VectorValue& a,
              const VectorValue& b) {
    if (a.algebra != b.algebra || !is_multiplied(a)) {
        return mismatch(lowering, span,
                        fmt::format("{} and {} cannot be multiplied; {}", describe(a), describe(b),
                                    product_hint(a, b)));
    }
    Graph& graph = lowering.field.graph;
    VectorValue result = a.algebra == Algebra::complex
                             ? value(complex_of(graph, a) * complex_of(graph, b))
                             : value(quaternion_of(graph, a) * quaternion_of(graph, b));
    result.orbit = orbit_of_product(lowering, a, b);
    return result;
}

Value quotient(Lowering& lowering, base::SourceSpan span, const Value& a, const VectorValue& b) {
    const auto* vector = std::get_if<VectorValue>(&a);
    if (!is_multiplied(b) || (vector && vector->algebra != b.algebra)) {
        return mismatch(lowering, span,
                        fmt::format("{} cannot be divided by {}; divide by a number, or the "
                                    "components",
                                    describe(a), describe(b)));
    }
    Graph& graph = lowering.field.graph;
    if (!vector) {
        const VectorValue inverted = *inverse(lowering, b);
        return combine(lowering, Joint::times, span, a, inverted);
    }
    if (b.algebra == Algebra::complex)
        return value(complex_of(graph, *vector) / complex_of(graph, b));
    return value(quaternion_of(graph, *vector) / quaternion_of(graph, b));
}

Value power(Lowering& lowering, base::SourceSpan span, const VectorValue& a, NodeId exponent) {
    if (a.algebra == Algebra::vector) {
        return mismatch(lowering, span,
                        fmt::format("{} has no powers; write dot(v, v) for the square of its length"
                                    "{}",
                                    describe(a),
                                    a.components.size() == 4   ? ", or quaternion(v)^n"
                                    : a.components.size() == 3 ? ", or triplex(v)^n"
                                                               : ", or complex(v)^n"));
    }
    const std::optional<int> n = whole(lowering, exponent);
    const bool squared = n && (a.algebra != Algebra::triplex || *n >= 1);
    VectorValue result =
        squared ? whole_power(lowering, a, *n) : power_by_angle(lowering.field.graph, a, exponent);
    result.orbit = orbit_of_power(lowering, a, exponent, n);
    return result;
}

std::optional<VectorValue> conjugate(Lowering& lowering, const VectorValue& a) {
    Graph& graph = lowering.field.graph;
    if (!is_multiplied(a)) return std::nullopt;
    const Complex z = complex_of(graph, a);
    VectorValue result = a.algebra == Algebra::complex ? value(Complex{z.re, -z.im})
                                                       : value(conjugate(quaternion_of(graph, a)));
    result.orbit = a.orbit;
    return result;
}

std::optional<VectorValue> inverse(Lowering& lowering, const VectorValue& a) {
    Graph& graph = lowering.field.graph;
    if (!is_multiplied(a)) return std::nullopt;
    if (a.algebra == Algebra::complex) return value(inverse(complex_of(graph, a)));
    return value(inverse(quaternion_of(graph, a)));
}

}  // namespace formula
