// SPDX-License-Identifier: MIT
// Triplex numbers of graph nodes: points of space with powers, as the Mandelbulb needs them.
// Internal to the library.
#pragma once

#include "graph/build.h"

namespace formula {

struct Triplex {
    graph::Expr x, y, z;
};

/// a^n (White and Nylander): in spherical coordinates about the z axis the radius to the power n
/// and both angles times n. Equal to `whole_power`, which has no trigonometry, where n is whole.
Triplex real_power(Triplex a, graph::Expr n);

/// How far from the z axis that is, over how far a is.
graph::Expr real_power_around(Triplex a, graph::Expr n);

/// For n >= 2. By powers of z + i rho, which need rho^2 only, and of (x + i y) / rho, rho = |(x,
/// y)|.
Triplex whole_power(Triplex a, int n);

/// How far from the z axis that is, over how far a is: of the same expressions.
graph::Expr whole_power_around(Triplex a, int n);

}  // namespace formula
