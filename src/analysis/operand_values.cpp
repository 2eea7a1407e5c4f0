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

void OperandValues::find_places(std::size_t number, const OperandList& list) {
    places_.clear();
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (operands_.kind[list[i]] == number) places_.push_back(i);
    }
}

void OperandValues::of_kind(std::size_t number, std::span<const glm::dvec3> points,
                            const OperandList& list) {
    const Operands::Kind& kind = operands_.kinds[number];
    const bool all = operands_.kinds.size() == 1;
    if (!all) find_places(number, list);
    const std::size_t row = all ? list.size() : places_.size(), size = row * points.size();
    if (row == 0) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        columns_[axis].resize(size);
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::fill_n(columns_[axis].data() + i * row, row, points[i][static_cast<int>(axis)]);
        }
    }
    for (std::size_t k = 0; k < kind.variables.size(); ++k) {
        std::vector<double>& column = columns_[index(kind.variables[k])];
        column.resize(size);
        const double* const numbers = kind.numbers[k].data();
        if (all) {
            for (std::size_t i = 0; i < row; ++i) column[i] = numbers[list[i]];
        } else {
            for (std::size_t i = 0; i < row; ++i) {
                column[i] = numbers[operands_.place[list[places_[i]]]];
            }
        }
        for (std::size_t i = row; i < size; i += row) {
            std::copy_n(column.data(), row, column.data() + i);
        }
    }
    variables_.assign(columns_.begin(), columns_.end());
    if (!all) found_.resize(size);
    const std::array roots{all ? std::span(result_) : std::span(found_)};
    eval::evaluate_points(*kind.value, registers_[number], variables_, roots, scratch_);
    if (all) return;
    for (std::size_t point = 0; point < points.size(); ++point) {
        const double* const from = found_.data() + point * row;
        double* const to = result_.data() + point * list.size();
        for (std::size_t i = 0; i < row; ++i) to[places_[i]] = from[i];
    }
}

}  // namespace analysis
