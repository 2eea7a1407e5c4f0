// SPDX-License-Identifier: MIT
#include "analysis/running_error.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "analysis/operator_accuracy.h"
#include "graph/build.h"

namespace analysis {
namespace {

using graph::Expr;
using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

/// An error; empty is none, by structure.
using Error = std::optional<Expr>;

Error operator+(const Error& a, const Error& b) { return a && b ? Error(*a + *b) : (a ? a : b); }
Error operator*(const Error& a, Expr factor) { return a ? Error(*a * factor) : a; }

/// What an operator's own rounding adds to its value f.
Error own_error(Op op, Expr f, double part) {
    const Accuracy& accuracy = *accuracy_of(op);
    const double bound = part * accuracy.bound;
    switch (accuracy.unit) {
        case Unit::none:
            return std::nullopt;
        case Unit::absolute:
            return Expr(*f.graph, bound);
        case Unit::mixed:
            return max(abs(f), 1.0) * bound;
        case Unit::slope:
            return (f * f + 1.0) * bound;
        case Unit::relative:
        case Unit::power:  // none of those get here
            return abs(f) * bound;
    }
    return std::nullopt;
}

/// What the errors ea and eb of its arguments a and b make of an operator's value f; nothing where
/// no rule is known.
std::optional<Error> handed_on(Op op, Expr f, Expr a, const Error& ea, Expr b, const Error& eb) {
    switch (op) {
        case Op::neg:
        case Op::abs:
        case Op::sin:
        case Op::cos:
        case Op::atan:
        case Op::tanh:
            return ea;  // nowhere steeper than 1
        case Op::add:
        case Op::sub:
            return ea + eb;
        case Op::mul:
            if (a.id == b.id) return ea ? ea * (2.0 * abs(a) + *ea) : ea;
            return ea * (eb ? abs(b) + *eb : abs(b)) + eb * abs(a);
        case Op::min:
        case Op::max:
            return ea && eb ? Error(max(*ea, *eb)) : ea + eb;
        case Op::exp:
            return ea * f;
        case Op::sinh:
            return ea * (abs(f) + 1.0);
        case Op::cosh:
            return ea * f;
        default:
            return std::nullopt;
    }
}

/// A number that is handed over rounded.
Error handed_over(Graph& graph, NodeId id, double part) {
    const Node& node = graph[id];
    const bool exact = node.op == Op::constant &&
                       static_cast<double>(static_cast<float>(node.value)) == node.value;
    if (exact) return std::nullopt;
    return abs(Expr(graph, id)) * (part * 0x1p-23);
}

}  // namespace

std::vector<std::optional<NodeId>> running_errors(Graph& graph, std::span<const NodeId> roots,
                                                  NodeId position, double part) {
    const std::vector<bool> depends = depends_on_variables(graph);
    std::map<NodeId, Error> errors;  // of those nodes that have a bound
    for (const NodeId id : reachable(graph, roots)) {
        const Node node = graph[id];  // a copy: adding nodes moves them
        if (!depends[index(id)]) {
            errors[id] = handed_over(graph, id, part);
            continue;
        }
        if (node.op == Op::variable) {
            errors[id] = Expr(graph, position);
            continue;
        }
        const std::size_t count = node.args().size();
        const auto a = errors.find(node.arguments[0]), b = errors.find(node.arguments[count - 1]);
        if (count > 2 || a == errors.end() || b == errors.end()) continue;
        const Expr f(graph, id);
        const auto passed = handed_on(node.op, f, Expr(graph, a->first), a->second,
                                      Expr(graph, b->first), b->second);
        if (passed) errors[id] = *passed + own_error(node.op, f, part);
    }
    std::vector<std::optional<NodeId>> bounds;
    for (const NodeId root : roots) {
        const auto found = errors.find(root);
        if (found == errors.end()) {
            bounds.push_back(std::nullopt);
        } else {
            bounds.push_back(found->second ? found->second->id : graph.constant(0));
        }
    }
    return bounds;
}

}  // namespace analysis
