// SPDX-License-Identifier: MIT
// The part of a graph that some roots need, flattened for evaluating it many times.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "graph/graph.h"
#include "numeric/interval.h"

namespace eval {

/// A straight-line program over registers. The first `uniform_count` registers hold what is the
/// same for all points: the constants, the parameters, and the results of those instructions that
/// depend on no variable. The others hold the variables that the roots need, at first, and then
/// results; each is used again as soon as its content is needed no more (linear-scan allocation),
/// so that the working set stays small. Made by make_tape; independent of its graph afterwards.
struct Tape {
    struct Instruction {
        graph::Op op{};
        std::uint32_t result = 0;                                 ///< a register
        std::array<std::uint32_t, graph::max_arity> arguments{};  ///< registers; unused ones are 0
    };

    std::vector<double> constants;
    std::vector<graph::ParameterId> parameters;
    std::vector<graph::VariableId> variables;
    std::vector<Instruction> instructions;
    std::size_t independent = 0;  ///< so many instructions, the first ones, depend on no variable
    std::size_t register_count = 0;
    std::vector<std::uint32_t> roots;  ///< registers

    std::size_t uniform_count() const { return constants.size() + parameters.size() + independent; }
};

/// Takes time in proportion to what the roots need, however large the graph is. Arguments come
/// before their users, each as late as the order of the roots allows (depth first).
Tape make_tape(const graph::Graph& graph, std::span<const graph::NodeId> roots);

/// Fills the registers that depend on no variable; to be done once for all points of a frame.
/// `parameters` is indexed by ParameterId and has a value for each that the tape needs. The
/// registers are resized as needed. T is, here and below, double, numeric::Interval, or a jet over
/// one of them: Dual<T>, SecondOrder<T> and SecondOrder<T, 1> of numeric/jet.h.
template <class T>
void load_parameters(const Tape& tape, std::span<const T> parameters, std::vector<T>& registers);

/// Evaluates the roots at `variables` (indexed by VariableId, a value for each that the tape
/// needs), with registers that load_parameters filled for this tape.
template <class T>
void evaluate_loaded(const Tape& tape, std::span<const T> variables, std::span<T> roots,
                     std::vector<T>& registers);

/// Both of the above. `scratch` may hold anything; keeping it between calls saves allocations.
template <class T>
void evaluate(const Tape& tape, std::span<const T> variables, std::span<const T> parameters,
              std::span<T> roots, std::vector<T>& scratch);

/// One node at one point; parameters that are not given are 0. Makes a tape each time: for single
/// values and tests.
double evaluate(const graph::Graph& graph, graph::NodeId root, glm::dvec3 point,
                std::span<const double> parameters = {});

/// An enclosure of the node's values over a box.
numeric::Interval enclose(const graph::Graph& graph, graph::NodeId root,
                          const std::array<numeric::Interval, 3>& box,
                          std::span<const double> parameters = {});

}  // namespace eval
