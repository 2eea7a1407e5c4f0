// SPDX-License-Identifier: MIT
// Many alike operands of a union or of a minimum, and their values at points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "eval/tape.h"

namespace analysis {

/// Operands by kinds: those of one kind have one tape and differ in some of its variables.
struct Operands {
    struct Kind {
        /// Of the point and `variables`; 1-Lipschitz in the point.
        const eval::Tape* value = nullptr;
        std::span<const graph::VariableId> variables;
        std::vector<std::vector<double>> numbers;  ///< of each variable: one for each of the kind
    };
    std::vector<Kind> kinds;
    std::vector<std::uint32_t> kind;   ///< of each operand
    std::vector<std::uint32_t> place;  ///< of each operand among those of its kind
    /// Of the tapes, by ParameterId: what all of a kind have in common may depend on them.
    std::span<const double> parameters{};
};

/// Some of the operands, by number.
using OperandList = std::vector<std::uint32_t>;

/// Evaluates operands. Keeps a reference to them; for one thread.
class OperandValues {
public:
    explicit OperandValues(const Operands& operands);

    /// Row after row, one for each point, the values of the operands in the list. They hold until
    /// the next call.
    std::span<const double> at(std::span<const glm::dvec3> points, const OperandList& list);

private:
    void find_places(std::size_t number, const OperandList& list);
    void of_kind(std::size_t number, std::span<const glm::dvec3> points, const OperandList& list);

    const Operands& operands_;
    std::vector<std::vector<double>> registers_;      ///< of the kinds
    std::vector<std::vector<double>> columns_;        ///< by variable
    std::vector<std::span<const double>> variables_;  ///< the columns
    std::vector<std::size_t> places_;                 ///< in the list, of one kind of several
    std::vector<double> found_, result_, scratch_;
};

}  // namespace analysis
