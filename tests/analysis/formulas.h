// SPDX-License-Identifier: MIT
// Formulas that the analyses are tested on.
#pragma once

#include <cmath>

#include "eval/tape.h"
#include "graph/build.h"
#include "passes/pipeline.h"

namespace analysis {

/// A graph with x, y, z at hand, and the formula that `build` makes of them, passed through the
/// passes.
struct Formula {
    graph::Graph graph;
    graph::NodeId value{};

    template <class Build>
    explicit Formula(Build build) {
        const auto at = [&](graph::VariableId id) {
            return graph::Expr(graph, graph.variable(id));
        };
        const graph::Expr built =
            build(at(graph::variable_x), at(graph::variable_y), at(graph::variable_z));
        value = passes::run(graph, std::array{built.id})[0];
    }
};

inline eval::Tape tape_of(const Formula& f) {
    return eval::make_tape(f.graph, std::array{f.value});
}

inline graph::Expr squared(graph::Expr a) { return a * a; }

/// Barth's sextic with 65 nodes.
inline graph::Expr barth_sextic(graph::Expr x, graph::Expr y, graph::Expr z) {
    const double phi = (1 + std::sqrt(5.0)) / 2;
    const graph::Expr x2 = squared(x), y2 = squared(y), z2 = squared(z);
    return 4.0 * (phi * phi * x2 - y2) * (phi * phi * y2 - z2) * (phi * phi * z2 - x2) -
           (1 + 2 * phi) * squared(x2 + y2 + z2 - 1.0);
}

inline graph::Expr gyroid(graph::Expr x, graph::Expr y, graph::Expr z) {
    return sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x);
}

inline graph::Expr torus(graph::Expr x, graph::Expr y, graph::Expr z) {
    const graph::Expr s = squared(x) + squared(y) + squared(z);
    return squared(s + 0.75) - 4.0 * (squared(x) + squared(y));
}

}  // namespace analysis
