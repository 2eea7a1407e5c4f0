// SPDX-License-Identifier: MIT
#include "analysis/operand_values.h"

#include <algorithm>
#include <array>

#include "eval/batch.h"

namespace analysis {

OperandValues::OperandValues(const Operands& operands) : operands_(operands) {
    std::size_t variables = 3;
    for (const Operands::Kind& kind : operands.kinds) {
        eval::load_parameters<double>(*kind.value, operands.parameters, registers_.emplace_back());
        for (const graph::VariableId id : kind.variables) {
            variables = std::max(variables, index(id) + 1);
        }
    }
    columns_.resize(variables);
}

std::span<const double> OperandValues::at(std::span<const glm::dvec3> points,
                                          const OperandList& list) {
    result_.resize(points.size() * list.size());
    for (std::size_t kind = 0; kind < operands_.kinds.size(); ++kind) of_kind(kind, points, list);
    return result_;
}

void OperandValues::of_kind(std::size_t number, std::span<const glm::dvec3> points,
                            const OperandList& list) {
    const Operands::Kind& kind = operands_.kinds[number];
    places_.clear();
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (operands_.kind[list[i]] == number) places_.push_back(i);
    }
    if (places_.empty()) return;
    const std::size_t row = places_.size(), size = row * points.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        columns_[axis].clear();
        for (const glm::dvec3& point : points) {
            columns_[axis].insert(columns_[axis].end(), row, point[static_cast<int>(axis)]);
        }
    }
    for (std::size_t k = 0; k < kind.variables.size(); ++k) {
        std::vector<double>& column = columns_[index(kind.variables[k])];
        column.resize(size);
        for (std::size_t i = 0; i < row; ++i) {
            column[i] = kind.numbers[k][operands_.place[list[places_[i]]]];
        }
        for (std::size_t i = row; i < size; ++i) column[i] = column[i - row];
    }
    std::vector<std::span<const double>> variables(columns_.begin(), columns_.end());
    found_.resize(size);
    const std::array roots{std::span(found_)};
    eval::evaluate_points(*kind.value, registers_[number], variables, roots, scratch_);
    for (std::size_t i = 0; i < size; ++i) {
        result_[i / row * list.size() + places_[i % row]] = found_[i];
    }
}

}  // namespace analysis
