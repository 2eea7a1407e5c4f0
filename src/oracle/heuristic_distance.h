// SPDX-License-Identifier: MIT
// Distances of solids as far as they can be told at a point, in double precision.
#pragma once

#include <vector>

#include "numeric/jet.h"
#include "oracle/values.h"

namespace oracle {

/// Heuristic: an iteration gives its own estimate, a formula that is no distance half of |f| /
/// |grad f|, a blend its value; set operations as usual. The sign is right: at most 0 inside. Not
/// for several threads.
class HeuristicDistance {
public:
    explicit HeuristicDistance(const Shape& shape);

    double operator()(std::size_t solid, glm::dvec3 point);
    /// Of a solid with operands the one that decides there, of a blend the one that is nearest.
    std::size_t operand(std::size_t solid, glm::dvec3 point);
    /// The leaf that decides, through all operands.
    std::size_t leaf(std::size_t solid, glm::dvec3 point);

private:
    /// Of operands: their values, not their distances.
    enum class What { value, distance };
    struct LoopRegisters {
        std::vector<double> point, start, step, escape, distance;
    };

    double of(std::size_t solid, What what);
    double formula(const Solid& node, What what);
    double loop(std::size_t number);
    double blend(const Solid& node);
    void run(const eval::Tape& tape, std::vector<double>& registers, std::span<double> roots);

    const Shape& shape_;
    glm::dvec3 point_{0};
    std::vector<double> variables_, results_;
    std::vector<LoopRegisters> loop_registers_;
    Values<double> values_;
    Values<numeric::Dual<double>> gradients_;
};

}  // namespace oracle
