// SPDX-License-Identifier: MIT
// Distance estimates of escape-time sets from their orbits z, functions of the point p. Everything
// here is heuristic: an estimate is meant to be at most the distance, and is not proven to be
// (docs/numerics.md).
#pragma once

#include <optional>
#include <span>

#include "field/field.h"

namespace passes {

/// |dz/dp|, carried along as one number.
struct RunningDerivative {
    graph::VariableId variable{};  ///< what stands for it in the step
    graph::NodeId start{};         ///< of the point
    graph::NodeId step{};          ///< after a turn, of state, point and `variable`
};

/// Where an orbit that grows without bound stands to the set of those that never get as far as
/// `radius` within the limit of turns; degree or scale, and the radius, are the same everywhere.
struct Escape {
    /// Of an orbit with |z| -> |z|^degree, degree > 1, where it is large; otherwise |z| -> scale
    /// |z|.
    bool by_power = true;
    std::optional<graph::NodeId> rate{};  ///< degree or scale; none if not the same at each turn
    graph::NodeId radius{};               ///< above 1
};

/// Adds the running derivative to the state; the node is its value. Where lengths only multiply it,
/// its square is carried, which needs no root.
graph::NodeId add_growth(graph::Graph& graph, field::Iteration& iteration,
                         const RunningDerivative& derivative);

/// Adds the Jacobian of the orbit (the first `orbit_size` state variables) by x, y and z to the
/// state, with as many further rows as the step of the orbit needs (dual numbers: value and three
/// partial derivatives side by side). The node is its Frobenius norm: at least the largest stretch
/// of the orbit, at most sqrt(3) times as much.
graph::NodeId add_jacobian_norm(graph::Graph& graph, field::Iteration& iteration,
                                std::size_t orbit_size);

/// The estimated distance of the point from the set, of the last state, with |z| in `orbit_length`
/// and |dz/dp| in `growth`:
/// - by power 1/2 |z| (log|z| - log(radius) degree^-rest) / growth: half of the potential over its
///   gradient (methods: K 107), with the potential of the drawn set's boundary taken off;
/// - linear (|z| - radius scale^-rest) / growth.
/// `rest` is the number of turns left, so that the estimate goes to 0 at the boundary of what is
/// drawn; without a rate nothing is taken off. May add a number to the state.
graph::NodeId distance_estimate(graph::Graph& graph, field::Iteration& iteration,
                                graph::NodeId orbit_length, const Escape& escape,
                                graph::NodeId growth);

/// How |root| grows with the size of the state that is listed, while all else stays: the exponent
/// of an upper bound for large states, 0 for what is bounded; nothing if that is no power. Upper
/// bounds may not be reached where terms cancel: heuristic as a degree.
std::optional<double> heuristic_order(const graph::Graph& graph, graph::NodeId root,
                                      std::span<const graph::VariableId> state);

}  // namespace passes
