// SPDX-License-Identifier: MIT
#include "contract/running_error.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <unordered_map>
#include <vector>

#include "eval/operators.h"

namespace contract {
namespace {

using graph::Op;
using numeric::infinity;
using numeric::Interval;
using single = std::numeric_limits<float>;

using Box = std::array<Interval, graph::max_arity>;

Interval unknown() { return {-infinity, infinity, true}; }

Interval widened(const Interval& a, double by) {
    return {numeric::add_down(a.lo, -by), numeric::add_up(a.hi, by), a.partial, a.jumps};
}

/// Numbers too small for single precision may be 0, too large ones infinite.
Interval in_single_precision(Interval a) {
    constexpr double least = single::min(), largest = 0.99 * single::max();
    if (a.is_empty()) return a;
    if (a.lo < least && a.hi > -least) {
        a.lo = std::min(a.lo, -least);
        a.hi = std::max(a.hi, least);
    }
    if (a.lo < -largest) a.lo = -infinity;
    if (a.hi > largest) a.hi = infinity;
    return a;
}

Interval result_of(Op op, const Box& box, bool is_square) {
    const Interval exact =
        is_square ? square(box[0]) : eval::apply<Interval>(op, box[0], box[1], box[2], box[3]);
    if (exact.is_empty()) {
        // A quotient or power with a pole everywhere is infinite, not undefined.
        const bool may_be_a_pole = op == Op::div || op == Op::pow;
        const bool from_nothing = box[0].is_empty() || box[1].is_empty();
        return may_be_a_pole && !from_nothing ? unknown() : exact;
    }
    const Row& row = *analysis::accuracy_of(op);
    if (!analysis::is_promised(row, box)) return unknown();
    return in_single_precision(
        widened(exact, row.bound * analysis::largest_size(row.unit, box[1], exact)));
}

Interval constant_of(double number) {
    const auto rounded = static_cast<double>(static_cast<float>(number));
    const Interval both{std::min(number, rounded), std::max(number, rounded)};
    // Compilers may read a decimal number with an error in the last place.
    return in_single_precision(number == rounded ? both : widened(both, 1.2e-7 * magnitude(both)));
}

}  // namespace

Interval gpu_enclosure(const graph::Graph& graph, graph::NodeId root, const Arguments& point) {
    std::unordered_map<graph::NodeId, Interval> values;
    for (const graph::NodeId id : reachable(graph, std::array{root})) {
        const graph::Node& node = graph[id];
        assert(node.op != Op::parameter);
        if (node.op == Op::constant) values[id] = constant_of(node.value);
        if (node.op == Op::variable) values[id] = static_cast<double>(point[node.symbol]);
        if (node.args().empty()) continue;
        Box box;
        std::ranges::transform(node.args(), box.begin(),
                               [&](graph::NodeId argument) { return values.at(argument); });
        const bool is_square = node.op == Op::mul && node.arguments[0] == node.arguments[1];
        values[id] = result_of(node.op, box, is_square);
    }
    return values.at(root);
}

}  // namespace contract
