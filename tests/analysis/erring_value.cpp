// SPDX-License-Identifier: MIT
#include "analysis/erring_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "analysis/operator_accuracy.h"
#include "eval/operators.h"

namespace analysis {

double rounded(double value) { return static_cast<double>(static_cast<float>(value)); }

namespace {

/// An operator on numbers in single precision that errs as much as it may, to either side.
double erring(graph::Op op, const std::array<double, 4>& a, Random& random) {
    const double exact = eval::apply<double>(op, a[0], a[1], a[2], a[3]);
    const Accuracy& accuracy = *accuracy_of(op);
    if (accuracy.unit == Unit::none) return rounded(exact);
    // What rounding to a float leaves of the promise.
    const double most = std::max(
        0.0, accuracy.bound * size_of(accuracy.unit, a[1], exact) - 0x1.02p-24 * std::abs(exact));
    return rounded(exact + (random() % 2 ? most : -most));
}

}  // namespace

double erring_value(const eval::Tape& tape, const std::vector<double>& variables, Random& random) {
    std::vector<double> registers;
    eval::load_parameters<double>(tape, {}, registers);
    for (double& it : registers) it = rounded(it);
    std::size_t next = tape.uniform_count();
    for (const graph::VariableId id : tape.variables) registers[next++] = variables[index(id)];
    for (const auto& it : std::span(tape.instructions).subspan(tape.independent)) {
        std::array<double, 4> a;
        for (std::size_t i = 0; i < 4; ++i) a[i] = registers[it.arguments[i]];
        registers[it.result] = erring(it.op, a, random);
    }
    return registers[tape.roots[0]];
}

}  // namespace analysis
