// SPDX-License-Identifier: MIT
// Builders of the built-in fractals, as iterations around graphs.
#pragma once

#include <span>

#include "field/field.h"

namespace field {

/// The quaternion Julia set of q^2 + c. Arguments: the four components of c, the number of
/// iterations, the fourth component of the start. The estimate is 1/2 |q| log|q| / |q'|
/// (methods: K 107), with the potential of the drawn set's own boundary |q_N| = 4 taken off, so
/// that it goes to 0 there and not at the limit set inside. Heuristic: at most 0.8 of the distance
/// in all that has been sampled (docs/numerics.md).
FieldId julia(Field& field, std::span<const graph::NodeId> arguments);

/// The Mandelbulb (White and Nylander): z -> z^n + p in spherical coordinates about the z axis.
/// Arguments: power, iterations. A constant whole power from 2 to 32 is computed by complex
/// multiplications, anything else by trigonometry. The estimate is of the same form as julia's.
/// Heuristic: in what has been sampled at most the distance at 99 points of 100, and at worst seven
/// times the distance (docs/numerics.md).
FieldId mandelbulb(Field& field, std::span<const graph::NodeId> arguments);

/// The Menger sponge of finitely many levels: at each level the infinite cross-shaped holes are cut
/// from the cube. Argument: levels. A signed distance bound, 1-Lipschitz.
FieldId menger(Field& field, std::span<const graph::NodeId> arguments);

}  // namespace field
