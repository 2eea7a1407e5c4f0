// SPDX-License-Identifier: MIT
#include "passes/recentre.h"

#include <optional>
#include <vector>

#include "passes/pipeline.h"
#include "passes/rate.h"
#include "passes/rewrite.h"

namespace passes {
namespace {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

/// A value in two parts: the origin's, which is the same at every point, and how far the value at
/// a point is from that, found without the difference of large numbers. One of them may be missing,
/// which is 0.
struct Apart {
    std::optional<NodeId> origin, here;
};

class Recentring {
public:
    Recentring(Graph& graph, const std::array<graph::ParameterId, 3>& origin)
        : graph_(graph), rates_(graph), origin_(origin) {}

    std::vector<NodeId> operator()(std::span<const NodeId> roots) {
        std::vector<NodeId> result;
        for (const NodeId id : reachable(graph_, roots)) {
            if (parts_.size() <= index(id)) parts_.resize(index(id) + 1);
            parts_[index(id)] = apart(id);
        }
        for (const NodeId root : roots) result.push_back(joined(parts_[index(root)]));
        return result;
    }

private:
    using Part = std::optional<NodeId>;

    template <class... Ids>
    NodeId apply(Op op, Ids... ids) {
        return graph_.apply(op, ids...);
    }
    NodeId number(double value) { return graph_.constant(value); }
    Part sum(Part a, Part b) { return a && b ? Part(apply(Op::add, *a, *b)) : (a ? a : b); }
    Part negative(Part a) { return a ? Part(apply(Op::neg, *a)) : a; }
    Part difference(Part a, Part b) {
        return a && b ? Part(apply(Op::sub, *a, *b)) : (a ? a : negative(b));
    }
    Part product(Part a, Part b) { return a && b ? Part(apply(Op::mul, *a, *b)) : std::nullopt; }
    Part quotient(Part a, Part b) { return a ? Part(apply(Op::div, *a, *b)) : a; }

    NodeId joined(const Apart& value) {
        const Part whole = sum(value.here, value.origin);
        return whole ? *whole : number(0);
    }

    /// (a + x)(b + y) = ab + (ay + bx + xy).
    Apart multiplied(const Apart& a, const Apart& b) {
        const Part cross = sum(product(a.origin, b.here), product(b.origin, a.here));
        return {product(a.origin, b.origin), sum(product(a.here, b.here), cross)};
    }

    /// max(a + x, b + y) = m + max(x + (a - m), y + (b - m)) with m = max(a, b), and min likewise.
    Apart extreme(Op op, const Apart& a, const Apart& b) {
        const NodeId zero = number(0);
        const NodeId most = apply(op, a.origin.value_or(zero), b.origin.value_or(zero));
        const auto beside = [&](const Apart& it) {
            return *sum(it.here, difference(it.origin, most));
        };
        return {most, apply(op, beside(a), beside(b))};
    }

    /// |a + x| = |a| + max(s x, -s x - 2 |a|) with s the sign of a.
    Apart size(const Apart& a) {
        if (!a.origin || !a.here) return {{}, apply(Op::abs, joined(a))};
        const NodeId most = apply(Op::abs, *a.origin);
        const NodeId sign = apply(Op::select_less, *a.origin, number(0), number(-1), number(1));
        const NodeId along = apply(Op::mul, sign, *a.here);
        const NodeId back = apply(Op::sub, apply(Op::neg, along), apply(Op::mul, number(2), most));
        return {most, apply(Op::max, along, back)};
    }

    /// sqrt(a + x) = r + (a - r^2 + x) / (sqrt(a + x) + r) with r = sqrt(max(a, 0)).
    Apart root(const Apart& a) { return root(a, joined(a)); }
    /// A sum of squares is not negative, whatever rounding makes of it.
    Apart length(const Apart& a) { return root(a, apply(Op::max, joined(a), number(0))); }
    Apart root(const Apart& a, NodeId square) {
        const NodeId whole = apply(Op::sqrt, square);
        if (!a.origin || !a.here) return {{}, whole};
        const NodeId root = apply(Op::sqrt, apply(Op::max, *a.origin, number(0)));
        const NodeId above = apply(Op::add, apply(Op::min, *a.origin, number(0)), *a.here);
        const NodeId below = apply(Op::max, apply(Op::add, whole, root), number(1e-30));
        return {root, apply(Op::div, above, below)};
    }

    /// sin(a + x) = sin a + 2 sin(x / 2) (cos a cos(x / 2) - sin a sin(x / 2)), and the cosine,
    /// which is the sine a quarter of a turn ahead, likewise.
    Apart wave(Op op, const Apart& a) {
        if (!a.origin || !a.here) return {{}, apply(op, joined(a))};
        const NodeId part = apply(Op::mul, number(0.5), *a.here);
        const NodeId sine = apply(Op::sin, part), cosine = apply(Op::cos, part);
        const NodeId value = apply(op, *a.origin);
        const NodeId slope =
            op == Op::sin ? apply(Op::cos, *a.origin) : apply(Op::neg, apply(Op::sin, *a.origin));
        const NodeId inner =
            apply(Op::sub, apply(Op::mul, slope, cosine), apply(Op::mul, value, sine));
        return {value, apply(Op::mul, apply(Op::mul, number(2), sine), inner)};
    }

    /// The sum of two squares.
    Apart square_sum(const Apart& a, const Apart& b) {
        const Apart p = multiplied(a, a), q = multiplied(b, b);
        return {sum(p.origin, q.origin), sum(p.here, q.here)};
    }

    Apart apart(NodeId id) {
        const Node node = graph_[id];
        if (node.op == Op::variable && node.symbol < 3) {
            return {graph_.parameter(origin_[node.symbol]), id};
        }
        if (rates_[id] < Rate::point) return {id, {}};
        if (node.args().empty()) return {{}, id};
        const auto part = [&](std::size_t i) { return parts_[index(node.arguments[i])]; };
        const Apart a = part(0), b = part(node.args().size() > 1 ? 1 : 0);
        switch (node.op) {
            case Op::neg:
                return {negative(a.origin), negative(a.here)};
            case Op::add:
                return {sum(a.origin, b.origin), sum(a.here, b.here)};
            case Op::sub:
                return {difference(a.origin, b.origin), difference(a.here, b.here)};
            case Op::mul:
                return multiplied(a, b);
            case Op::div:
                if (!b.here) return {quotient(a.origin, b.origin), quotient(a.here, b.origin)};
                break;
            case Op::min:
            case Op::max:
                return extreme(node.op, a, b);
            case Op::abs:
                return size(a);
            case Op::sqrt:
                return root(a);
            case Op::hypot:
                return length(square_sum(a, b));
            case Op::hypot3: {
                const Apart c = part(2), square = multiplied(c, c), two = square_sum(a, b);
                return length({sum(two.origin, square.origin), sum(two.here, square.here)});
            }
            case Op::sin:
            case Op::cos:
                return wave(node.op, a);
            default:
                break;
        }
        Node whole = node;
        for (std::size_t i = 0; i < node.args().size(); ++i) whole.arguments[i] = joined(part(i));
        return {{}, graph_.apply(whole.op, whole.args())};
    }

    Graph& graph_;
    Rates rates_;
    const std::array<graph::ParameterId, 3>& origin_;
    std::vector<Apart> parts_;
};

}  // namespace

std::array<graph::ParameterId, 3> recentre(field::Field& field) {
    const std::array origin{field.graph.new_parameter("origin.x"),
                            field.graph.new_parameter("origin.y"),
                            field.graph.new_parameter("origin.z")};
    const std::vector<NodeId*> places = all_expressions(field);
    std::vector<NodeId> roots;
    for (const NodeId* place : places) roots.push_back(*place);
    const std::vector<NodeId> made = Recentring(field.graph, origin)(roots);
    for (std::size_t i = 0; i < places.size(); ++i) *places[i] = made[i];
    run(field);
    return origin;
}

}  // namespace passes
