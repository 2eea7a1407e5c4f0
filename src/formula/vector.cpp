// SPDX-License-Identifier: MIT
#include "formula/vector.h"

#include <cassert>

namespace formula {
namespace {

using graph::Expr;

template <class Operation>
Components each(const Components& a, Operation operation) {
    Components result;
    result.reserve(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) result.push_back(operation(i));
    return result;
}

}  // namespace

Components components(graph::Graph& graph, const std::vector<graph::NodeId>& nodes) {
    Components result;
    result.reserve(nodes.size());
    for (const graph::NodeId node : nodes) result.emplace_back(graph, node);
    return result;
}

std::vector<graph::NodeId> nodes(const Components& components) {
    std::vector<graph::NodeId> result;
    result.reserve(components.size());
    for (const Expr& it : components) result.push_back(it.id);
    return result;
}

Components operator+(const Components& a, const Components& b) {
    return each(a, [&](std::size_t i) { return a[i] + b[i]; });
}

Components operator-(const Components& a, const Components& b) {
    return each(a, [&](std::size_t i) { return a[i] - b[i]; });
}

Components operator-(const Components& a) {
    return each(a, [&](std::size_t i) { return -a[i]; });
}

Components operator*(Expr factor, const Components& a) {
    return each(a, [&](std::size_t i) { return factor * a[i]; });
}

Components operator*(const Components& a, Expr factor) {
    return each(a, [&](std::size_t i) { return a[i] * factor; });
}

Components operator/(const Components& a, Expr divisor) {
    return each(a, [&](std::size_t i) { return a[i] / divisor; });
}

Expr dot(const Components& a, const Components& b) {
    assert(a.size() == b.size());
    // Of four the last three first, which a quaternion's square needs as well.
    const std::size_t first = a.size() == 4 ? 1 : 0;
    Expr sum = a[first] * b[first];
    for (std::size_t i = first + 1; i < a.size(); ++i) sum = sum + a[i] * b[i];
    return first == 0 ? sum : a[0] * b[0] + sum;
}

Components cross(const Components& a, const Components& b) {
    assert(a.size() == 3 && b.size() == 3);
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Expr length(const Components& a) {
    if (a.size() == 2) return hypot(a[0], a[1]);
    if (a.size() == 3) return hypot(a[0], a[1], a[2]);
    return sqrt(dot(a, a));
}

}  // namespace formula
