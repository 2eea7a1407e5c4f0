// SPDX-License-Identifier: MIT
#include "formula/vector_functions.h"

#include <fmt/format.h>

#include <algorithm>

#include "formula/arithmetic.h"
#include "formula/orbit.h"
#include "formula/products.h"
#include "formula/rotation.h"
#include "formula/vector.h"

namespace formula {
namespace {

using graph::Expr;
using graph::Graph;
using graph::NodeId;

const VectorValue* vector_at(const VectorCall& call, std::size_t i) {
    return std::get_if<VectorValue>(&call.arguments[i]);
}

Graph& graph_of(const VectorCall& call) { return call.lowering.field.graph; }

Components parts_at(const VectorCall& call, std::size_t i) {
    return components(graph_of(call), vector_at(call, i)->components);
}

/// The number that was given, or what stands for it; nothing if a vector was given.
std::optional<Expr> number_at(const VectorCall& call, std::size_t i, double otherwise) {
    if (is_nothing(call.arguments[i])) return Expr(graph_of(call), otherwise);
    const auto* number = std::get_if<NodeId>(&call.arguments[i]);
    if (!number) return std::nullopt;
    return Expr(graph_of(call), *number);
}

/// The error for arguments of other types than the function takes.
Value refuse(const VectorCall& call, std::string_view takes) {
    std::string given;
    for (const Value& it : call.arguments) {
        if (is_nothing(it)) continue;
        given += (given.empty() ? "" : " and ") + describe(it);
    }
    call.lowering.error(
        call.span, fmt::format("'{}' takes {}, not {}; it is called '{}'", call.function, takes,
                               given, find_vector_function(call.function)->signature));
    return Nothing{};
}

/// True if the first two arguments are vectors that can be joined component by component.
bool are_two_alike(const VectorCall& call) {
    const VectorValue *a = vector_at(call, 0), *b = vector_at(call, 1);
    return a && b && common_algebra(*a, *b);
}

bool is_uniform(const VectorCall& call, std::size_t i) {
    const auto uniform = [&](NodeId id) {
        return !call.lowering.facts.depends_on_point(graph_of(call), id);
    };
    if (const auto* number = std::get_if<NodeId>(&call.arguments[i])) return uniform(*number);
    const VectorValue* vector = vector_at(call, i);
    return !vector || std::ranges::all_of(vector->components, uniform);
}

/// The same kind of vector with other components.
VectorValue like(const VectorValue& vector, const Components& parts, std::optional<Orbit> orbit) {
    return {vector.algebra, nodes(parts), orbit};
}

Value build_vector(const VectorCall& call, Algebra algebra, std::size_t size) {
    std::vector<NodeId> parts;
    if (const VectorValue* vector = vector_at(call, 0); vector && is_nothing(call.arguments[1])) {
        if (vector->components.size() == size)
            return VectorValue{algebra, vector->components, vector->orbit};
    }
    for (const Value& it : call.arguments) {
        if (const auto* number = std::get_if<NodeId>(&it)) parts.push_back(*number);
    }
    if (parts.size() == size) return VectorValue{algebra, std::move(parts)};
    return refuse(call, fmt::format("{} numbers or a vector of {}", size, size));
}

Value build_complex(const VectorCall& call) { return build_vector(call, Algebra::complex, 2); }
Value build_quaternion(const VectorCall& call) {
    return build_vector(call, Algebra::quaternion, 4);
}
Value build_triplex(const VectorCall& call) { return build_vector(call, Algebra::triplex, 3); }

Value build_length(const VectorCall& call) {
    if (!vector_at(call, 0)) return refuse(call, "a vector");
    return length(parts_at(call, 0)).id;
}

Value build_normalize(const VectorCall& call) {
    if (!vector_at(call, 0)) return refuse(call, "a vector");
    const Components parts = parts_at(call, 0);
    return like(*vector_at(call, 0), parts / length(parts), std::nullopt);
}

Value build_distance(const VectorCall& call) {
    if (!are_two_alike(call)) return refuse(call, "two vectors of one size");
    return length(parts_at(call, 0) - parts_at(call, 1)).id;
}

Value build_dot(const VectorCall& call) {
    if (!are_two_alike(call)) return refuse(call, "two vectors of one size");
    return dot(parts_at(call, 0), parts_at(call, 1)).id;
}

Value build_cross(const VectorCall& call) {
    if (!are_two_alike(call) || vector_at(call, 0)->components.size() != 3) {
        return refuse(call, "two vectors of 3");
    }
    return VectorValue{Algebra::vector, nodes(cross(parts_at(call, 0), parts_at(call, 1)))};
}

Value build_conjugate(const VectorCall& call) {
    const VectorValue* vector = vector_at(call, 0);
    const auto result = vector ? conjugate(call.lowering, *vector) : std::nullopt;
    if (!result) return refuse(call, "a complex number or a quaternion");
    return *result;
}

Value build_inverse(const VectorCall& call) {
    const VectorValue* vector = vector_at(call, 0);
    const auto result = vector ? inverse(call.lowering, *vector) : std::nullopt;
    if (!result) return refuse(call, "a complex number or a quaternion");
    return *result;
}

/// v - 2 (v.n / n.n) n
Value build_reflect(const VectorCall& call) {
    if (!are_two_alike(call)) return refuse(call, "two vectors of one size");
    const Components v = parts_at(call, 0), n = parts_at(call, 1);
    const Components mirrored = v - (2.0 * (dot(v, n) / dot(n, n))) * n;
    const VectorValue& vector = *vector_at(call, 0);
    return like(vector, mirrored, is_uniform(call, 1) ? vector.orbit : std::nullopt);
}

Value build_turn(const VectorCall& call) {
    const VectorValue *v = vector_at(call, 0), *axis = vector_at(call, 1);
    const auto* degrees = std::get_if<NodeId>(&call.arguments[2]);
    if (!v || !axis || !degrees || v->components.size() != 3 || axis->components.size() != 3) {
        return refuse(call, "two vectors of 3 and a number");
    }
    Direction direction{};
    for (std::size_t i = 0; i < 3; ++i) direction[i] = folded(call.lowering, axis->components[i]);
    if (std::ranges::all_of(direction,
                            [&](NodeId id) { return graph_of(call).is_constant(id, 0); })) {
        call.lowering.error(call.span, "the axis of 'turn' must not be zero");
        return Nothing{};
    }
    const auto to = turned(graph_of(call), {v->components[0], v->components[1], v->components[2]},
                           direction, folded(call.lowering, *degrees), Sense::forward);
    const bool isometry = is_uniform(call, 1) && is_uniform(call, 2);
    return VectorValue{v->algebra, {to.begin(), to.end()}, isometry ? v->orbit : std::nullopt};
}

/// 2 clamp(v, -size, size) - v
Value build_boxfold(const VectorCall& call) {
    const VectorValue* vector = vector_at(call, 0);
    const std::optional<Expr> size = number_at(call, 1, 1);
    if (!vector || !size) return refuse(call, "a vector and a number");
    Components parts = parts_at(call, 0);
    for (Expr& it : parts) it = min(max(it, -*size), *size) * 2.0 - it;
    return like(*vector, parts, is_uniform(call, 1) ? vector->orbit : std::nullopt);
}

/// The factor is (outer / inner)^2 inside of the inner radius, (outer / |v|)^2 between the two, and
/// 1 outside.
Value build_spherefold(const VectorCall& call) {
    const VectorValue* vector = vector_at(call, 0);
    const std::optional<Expr> inner = number_at(call, 1, 0.5), outer = number_at(call, 2, 1);
    if (!vector || !inner || !outer) return refuse(call, "a vector and two numbers");
    const Components parts = parts_at(call, 0);
    const Expr most = *outer * *outer;
    const Expr factor = most / max(min(dot(parts, parts), most), *inner * *inner);
    const bool known = is_uniform(call, 1) && is_uniform(call, 2);
    return like(*vector, factor * parts,
                known ? orbit_stretched(call.lowering, vector->orbit, factor.id) : std::nullopt);
}

constexpr Slot one_vector[] = {{"v", true}};
constexpr Slot one_q[] = {{"q", true}};
constexpr Slot two_vectors[] = {{"a", true}, {"b", true}};
constexpr Slot two_parts[] = {{"a", true}, {"b"}};
constexpr Slot three_parts[] = {{"x", true}, {"y"}, {"z"}};
constexpr Slot four_parts[] = {{"a", true}, {"b"}, {"c"}, {"d"}};
constexpr Slot mirrored[] = {{"v", true}, {"n", true}};
constexpr Slot turned_vector[] = {{"v", true}, {"axis", true}, {"degrees", true}};
constexpr Slot boxfolded[] = {{"v", true}, {"size"}};
constexpr Slot spherefolded[] = {{"v", true}, {"inner"}, {"outer"}};

constexpr VectorFunction table[] = {
    {"boxfold", "boxfold(v, size = 1)", boxfolded, build_boxfold},
    {"complex", "complex(a, b)", two_parts, build_complex},
    {"conj", "conj(q)", one_q, build_conjugate},
    {"cross", "cross(a, b)", two_vectors, build_cross},
    {"distance", "distance(a, b)", two_vectors, build_distance},
    {"dot", "dot(a, b)", two_vectors, build_dot},
    {"inverse", "inverse(q)", one_q, build_inverse},
    {"length", "length(v)", one_vector, build_length},
    {"normalize", "normalize(v)", one_vector, build_normalize},
    {"quaternion", "quaternion(a, b, c, d)", four_parts, build_quaternion},
    {"reflect", "reflect(v, n)", mirrored, build_reflect},
    {"spherefold", "spherefold(v, inner = 0.5, outer = 1)", spherefolded, build_spherefold},
    {"triplex", "triplex(x, y, z)", three_parts, build_triplex},
    {"turn", "turn(v, axis, degrees)", turned_vector, build_turn},
};

}  // namespace

std::span<const VectorFunction> vector_functions() { return table; }

const VectorFunction* find_vector_function(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &VectorFunction::name);
    return found == std::end(table) ? nullptr : found;
}

}  // namespace formula
