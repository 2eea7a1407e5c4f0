// SPDX-License-Identifier: MIT
#include "analysis/smoothness.h"

#include <array>
#include <cassert>
#include <vector>

#include "analysis/holds_everywhere.h"
#include "eval/operators.h"

namespace analysis {
namespace {

using graph::NodeId;
using graph::Op;
using numeric::Interval;

/// The values of a node over a cell, and whether it may have kinks there.
struct Values {
    Interval range;
    bool kinks = false;
};
using Arguments = std::array<Values, graph::max_arity>;

bool is_positive(const Interval& a) { return a.lo > 0; }
bool has_zero(const Interval& a) { return a.contains(0); }

/// True if the operator itself may have a kink at arguments in these ranges, of which at least one
/// depends on the point. Where the value stays on one side of the kink and touches it, a kink is
/// reported: the next cell may be on the other side.
bool has_kink(Op op, const Arguments& a, const Interval& result) {
    const Interval& first = a[0].range;
    const Interval& second = a[1].range;
    switch (op) {
        case Op::constant:
        case Op::variable:
        case Op::parameter:
        case Op::neg:
        case Op::add:
        case Op::sub:
        case Op::mul:
        case Op::div:
        case Op::sin:
        case Op::cos:
        case Op::tan:
        case Op::atan:
        case Op::sinh:
        case Op::cosh:
        case Op::tanh:
        case Op::exp:
        case Op::log:
            return false;
        case Op::pow:
            return !(second.is_point() && numeric::is_whole(second.lo)) && !is_positive(first);
        case Op::sqrt:
            return !is_positive(first);
        case Op::hypot:
        case Op::hypot3:
            return !is_positive(result);
        case Op::cbrt:
        case Op::abs:
            return has_zero(first);
        case Op::asin:
        case Op::acos:
            return !(-1 < first.lo && first.hi < 1);
        case Op::atan2:
        case Op::sign:
        case Op::floor:
        case Op::ceil:
        case Op::ratio:
            return result.jumps;
        case Op::min:
        case Op::max:
        case Op::select_less:
            break;  // these choose, see below
    }
    assert(false);
    return true;
}

/// The same for the node: also kinks of those arguments that show in it.
bool shows_kink(Op op, const Arguments& a, const Interval& result) {
    const auto chosen = [&](bool left, std::size_t one, bool right, std::size_t other) {
        if (left) return a[one].kinks;
        return right ? a[other].kinks : true;
    };
    if (op == Op::min || op == Op::max) {
        const bool less = a[0].range.hi < a[1].range.lo, more = a[1].range.hi < a[0].range.lo;
        return op == Op::min ? chosen(less, 0, more, 1) : chosen(less, 1, more, 0);
    }
    if (op == Op::select_less) {
        return chosen(a[0].range.hi < a[1].range.lo, 2, a[0].range.lo >= a[1].range.hi, 3);
    }
    return a[0].kinks || a[1].kinks || a[2].kinks || a[3].kinks || has_kink(op, a, result);
}

/// An expression that is looked at cell by cell.
class Expression {
public:
    Expression(const graph::Graph& graph, NodeId root, std::span<const double> parameters)
        : graph_(graph),
          order_(reachable(graph, std::array{root})),
          depends_(depends_on_variables(graph)),
          values_(graph.size()) {
        for (const NodeId id : order_) {
            const graph::Node& node = graph[id];
            if (node.op == Op::parameter) values_[index(id)].range = parameters[node.symbol];
            if (!depends_[index(id)] && node.op != Op::parameter) visit(id, node);
        }
    }

    const Values& over(const Cell& cell) {
        sides_ = cell.sides();
        for (const NodeId id : order_) {
            if (depends_[index(id)]) visit(id, graph_[id]);
        }
        return values_[index(order_.back())];
    }

private:
    void visit(NodeId id, const graph::Node& node) {
        Values& result = values_[index(id)];
        if (node.op == Op::constant) {
            result.range = node.value;
        } else if (node.op == Op::variable) {
            result.range = node.symbol < 3 ? sides_[node.symbol] : Interval::whole();
        } else {
            Arguments a;
            for (std::size_t i = 0; i < node.args().size(); ++i) {
                a[i] = values_[index(node.args()[i])];
            }
            const bool square = node.op == Op::mul && node.args()[0] == node.args()[1];
            result.range =
                square ? numeric::square(a[0].range)
                       : eval::apply(node.op, a[0].range, a[1].range, a[2].range, a[3].range);
            result.kinks = depends_[index(id)] && shows_kink(node.op, a, result.range);
        }
    }

    const graph::Graph& graph_;
    std::vector<NodeId> order_;
    std::vector<bool> depends_;
    std::vector<Values> values_;
    std::array<Interval, 3> sides_{};
};

}  // namespace

Regularity regularity(const graph::Graph& graph, NodeId root, const Region& region,
                      std::span<const double> parameters, const Effort& effort) {
    Expression expression(graph, root, parameters);
    const auto proven = [&](const std::function<bool(const Values&)>& holds) {
        return holds_everywhere(region, effort,
                                [&](const Cell& cell) { return holds(expression.over(cell)); });
    };
    Regularity result;
    result.partial = !proven([](const Values& f) { return !f.range.partial; });
    if (!proven([](const Values& f) { return !f.range.jumps; })) return result;
    const bool smooth = proven([](const Values& f) { return !f.kinks; });
    result.smoothness = smooth ? Smoothness::smooth : Smoothness::piecewise;
    return result;
}

}  // namespace analysis
