// SPDX-License-Identifier: MIT
#include "passes/jump_walls.h"

#include <algorithm>
#include <array>
#include <map>

#include "graph/build.h"

namespace passes {
namespace {

using graph::Expr;
using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

bool is_jump(Op op) {
    return op == Op::floor || op == Op::ceil || op == Op::sign || op == Op::select_less;
}

/// How an expression depends on the point between jumps.
enum class Shape { constant, affine, other };

Shape shape_of(const Node& node, const std::array<Shape, graph::max_arity>& of) {
    const auto args = node.args();
    const auto largest = [&](std::size_t first) {
        Shape result = Shape::constant;
        for (std::size_t i = first; i < args.size(); ++i) result = std::max(result, of[i]);
        return result;
    };
    switch (node.op) {
        case Op::variable:
            return Shape::affine;
        case Op::floor:
        case Op::ceil:
        case Op::sign:
            return Shape::constant;
        case Op::select_less:
            return largest(2);
        case Op::neg:
        case Op::add:
        case Op::sub:
            return largest(0);
        case Op::mul:
            return std::min(of[0], of[1]) == Shape::constant ? largest(0) : Shape::other;
        case Op::div:
            return of[1] == Shape::constant ? of[0] : Shape::other;
        default:
            return largest(0) == Shape::constant ? Shape::constant : Shape::other;
    }
}

/// The jumps on the point; nothing if one is not on planes.
std::vector<NodeId> jumps_of(const Graph& graph, NodeId root) {
    const std::vector<bool> depends = depends_on_variables(graph);
    std::map<NodeId, Shape> shapes;
    std::vector<NodeId> jumps;
    for (const NodeId id : reachable(graph, std::array{root})) {
        const Node& node = graph[id];
        if (!depends[index(id)]) {
            shapes[id] = Shape::constant;
            continue;
        }
        std::array<Shape, graph::max_arity> of{};
        for (std::size_t i = 0; i < node.args().size(); ++i) of[i] = shapes.at(node.arguments[i]);
        shapes[id] = shape_of(node, of);
        if (node.op == Op::atan2 || node.op == Op::ratio) return {};
        if (!is_jump(node.op)) continue;
        const bool compares = node.op == Op::select_less;
        if (of[0] == Shape::other || (compares && of[1] == Shape::other)) return {};
        jumps.push_back(id);
    }
    return jumps;
}

}  // namespace

bool jumps_at_planes(const Graph& graph, NodeId root) { return !jumps_of(graph, root).empty(); }

std::vector<NodeId> jump_walls(Graph& graph, NodeId root) {
    std::vector<NodeId> walls;
    for (const NodeId id : jumps_of(graph, root)) {
        const Node node = graph[id];  // a copy: adding nodes moves them
        const Expr u(graph, node.arguments[0]);
        if (node.op == Op::floor || node.op == Op::ceil) {
            const Expr below = u - floor(u);
            walls.push_back(below.id);
            walls.push_back((floor(u) + 1.0 - u).id);
        } else {
            const bool compares = node.op == Op::select_less;
            walls.push_back(abs(compares ? u - Expr(graph, node.arguments[1]) : u).id);
        }
    }
    return walls;
}

}  // namespace passes
