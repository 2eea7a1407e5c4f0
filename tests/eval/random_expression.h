// SPDX-License-Identifier: MIT
// Random numbers and expressions that favour the places where arithmetic goes wrong.
#pragma once

#include <random>

#include "graph/graph.h"

namespace eval {

using Random = std::mt19937_64;

/// Zeros, denormals, whole numbers, huge numbers and infinities, multiples of pi / 2, and ordinary
/// numbers. Never NaN.
double awkward_number(Random& random);

/// A number in [-4, 4], often whole.
double ordinary_number(Random& random);

/// A graph in x, y, z and one parameter `p` (or, with four variables, w instead) with about `size`
/// operators, and its last node. Every operator may occur, `ratio` only over a fitting length.
struct RandomExpression {
    graph::Graph graph;
    graph::NodeId root{};
};
RandomExpression random_expression(Random& random, int size, int variables = 3);

}  // namespace eval
