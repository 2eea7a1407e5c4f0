// SPDX-License-Identifier: MIT
#include "analysis/uniform_curvature.h"

#include <algorithm>
#include <array>
#include <vector>

#include "analysis/polynomial_degree.h"

namespace analysis {
namespace {

using graph::Op;

/// In increasing order: each holds what is before it.
enum class Shape { number, linear, wave, other };

struct Shapes {
    const graph::Graph& graph;
    std::vector<Shape> of{};

    Shape find(const graph::Node& node) const {
        if (node.op == Op::variable) return Shape::linear;
        Shape most = Shape::number;
        for (const graph::NodeId id : node.args()) most = std::max(most, of[index(id)]);
        if (most == Shape::number || most == Shape::other) return most;
        switch (node.op) {
            case Op::neg:
            case Op::add:
            case Op::sub:
                return most;
            case Op::mul:
                return product(of[index(node.args()[0])], of[index(node.args()[1])]);
            case Op::div:
                return of[index(node.args()[1])] == Shape::number ? most : Shape::other;
            case Op::sin:
            case Op::cos:
                return most == Shape::linear ? Shape::wave : Shape::other;
            default:
                return Shape::other;
        }
    }
    static Shape product(Shape a, Shape b) {
        if (a == Shape::number) return b;
        if (b == Shape::number) return a;
        return a == Shape::wave && b == Shape::wave ? Shape::wave : Shape::other;
    }
};

}  // namespace

bool has_uniform_curvature(const graph::Graph& graph, graph::NodeId root) {
    if (const auto degree = polynomial_degree(graph, root); degree && *degree <= 4) return true;
    Shapes shapes{graph, std::vector<Shape>(graph.size())};
    for (const graph::NodeId id : reachable(graph, std::array{root})) {
        shapes.of[index(id)] = shapes.find(graph[id]);
    }
    return shapes.of[index(root)] != Shape::other;
}

}  // namespace analysis
