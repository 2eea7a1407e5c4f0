// SPDX-License-Identifier: MIT
// Derivatives that are found in another way than by jets.
#pragma once

#include <array>

#include "eval/tape.h"
#include "passes/differentiate.h"

namespace analysis {

/// The value with its symbolic derivatives as roots: f, x, y, z, xx, yy, zz, xy, xz, yz.
inline eval::Tape symbolic_derivatives(graph::Graph g, graph::NodeId f) {
    const std::array first = passes::gradient(g, f);
    const std::array by_x = passes::gradient(g, first[0]);
    const std::array by_y = passes::gradient(g, first[1]);
    const std::array by_z = passes::gradient(g, first[2]);
    return eval::make_tape(g, std::array{f, first[0], first[1], first[2], by_x[0], by_y[1], by_z[2],
                                         by_x[1], by_x[2], by_y[2]});
}

}  // namespace analysis
