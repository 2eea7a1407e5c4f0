// SPDX-License-Identifier: MIT
// Evaluating expressions many times for the same parameters. Internal to the library.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "analysis/region.h"
#include "eval/tape.h"
#include "numeric/jet.h"

namespace analysis {

/// A tape with its parameters loaded, over numbers of one kind.
template <class T>
class RootEvaluator {
public:
    RootEvaluator(const eval::Tape& tape, std::span<const double> parameters)
        : tape_(tape), roots_(tape.roots.size()) {
        std::vector<T> loaded;
        for (const double parameter : parameters) loaded.push_back(T(parameter));
        eval::load_parameters<T>(tape, loaded, registers_);
    }

    std::span<const T> operator()(const std::array<T, 3>& variables) {
        eval::evaluate_loaded<T>(tape_, variables, roots_, registers_);
        return roots_;
    }

private:
    const eval::Tape& tape_;
    std::vector<T> registers_, roots_;
};

/// The coordinates of a place, or of all places in a cell, with their derivatives.
template <class T>
std::array<numeric::Dual<T>, 3> with_slopes(const std::array<T, 3>& at) {
    using numeric::Dual;
    return {Dual<T>::variable(at[0], 0), Dual<T>::variable(at[1], 1), Dual<T>::variable(at[2], 2)};
}

inline std::array<double, 3> coordinates(glm::dvec3 point) { return {point.x, point.y, point.z}; }

}  // namespace analysis
