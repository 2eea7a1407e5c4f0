// SPDX-License-Identifier: MIT
// How the operations on vectors carry on what is known of the growth of an iteration's state: the
// running derivative as one number, the degree, the factor in front. Internal to the library.
#pragma once

#include <optional>

#include "formula/lowering.h"
#include "graph/build.h"

namespace formula {

/// What is known of a vector that is no part of a state as well: the same at every point it has
/// stretch 0, and made of numbers and of distinct coordinates x, y, z stretch 1; of degree 0 both,
/// with its length as the scale. Nothing otherwise.
std::optional<Orbit> orbit_of(Lowering& lowering, const VectorValue& vector);

// The rules. Each gives nothing if an operand has nothing, and builds no nodes unless an operand
// has an orbit of its own.

/// a + b, a - b: the stretches add, the larger degree wins.
std::optional<Orbit> orbit_of_sum(Lowering& lowering, const VectorValue& a, const VectorValue& b);

/// number * v: multiplied by |number| if that is the same at every point and turn.
std::optional<Orbit> orbit_of_multiple(Lowering& lowering, graph::NodeId number,
                                       const VectorValue& v);

/// v / number, likewise.
std::optional<Orbit> orbit_of_fraction(Lowering& lowering, const VectorValue& v,
                                       graph::NodeId number);

/// a * b where |ab| = |a||b|: the product rule, the degrees add.
std::optional<Orbit> orbit_of_product(Lowering& lowering, const VectorValue& a,
                                      const VectorValue& b);

/// v^n where |v^n| = |v|^n: n |v|^(n-1) times the stretch, n times the degree.
std::optional<Orbit> orbit_of_power(Lowering& lowering, const VectorValue& v, graph::NodeId n);

/// v^n of triplex numbers, by the quotient of the distances to the z axis after and before. As such
/// the power has the customary estimate of the Mandelbulb, not a bound: in the half-plane of the
/// axis and v the map stretches by n |v|^(n-1) in all directions, as z^n does, but around the axis
/// by n times that quotient, which is up to n |v|^(n-1).
std::optional<Orbit> orbit_of_triplex_power(Lowering& lowering, const VectorValue& v,
                                            graph::NodeId n, graph::Expr around);

/// What is stretched by a factor that depends on the point, such as by the inversion of a sphere,
/// and grows as before.
std::optional<Orbit> orbit_stretched(Lowering& lowering, const std::optional<Orbit>& orbit,
                                     graph::NodeId factor);

}  // namespace formula
