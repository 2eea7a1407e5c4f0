// SPDX-License-Identifier: MIT
// The values of a shape's parts for one kind of numbers. Internal to the library.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "field/field.h"
#include "numeric/jet_operators.h"
#include "numeric/real.h"
#include "oracle/shape.h"

namespace oracle {

/// Of a solid: what is undefined is outside.
inline double outside_if_undefined(double value) {
    return std::isnan(value) ? numeric::infinity : value;
}
/// Only the ends count after it, and `jumps`: where the value is undefined it goes to +infinity.
inline numeric::Interval outside_if_undefined(const numeric::Interval& value) {
    if (value.is_empty()) return numeric::infinity;
    if (!value.partial) return value;
    return {value.lo, numeric::infinity, false, true};
}
template <numeric::AnyJet J>
J outside_if_undefined(J jet) {
    const bool defined = numeric::is_regular(jet.value);
    jet.value = outside_if_undefined(jet.value);
    jet.smooth = jet.smooth && defined;
    return jet;
}

/// As the operand of a blend: far away instead of infinite.
inline double as_operand(double value) {
    return std::clamp(value, -field::unknown_depth, field::unknown_depth);
}
inline numeric::Interval as_operand(const numeric::Interval& value) {
    return {as_operand(value.lo), as_operand(value.hi), value.partial, value.jumps};
}
template <numeric::AnyJet J>
J as_operand(J jet) {
    const auto near = as_operand(jet.value);
    if (!(near == jet.value)) jet = J(near), jet.smooth = false;
    return jet;
}

/// Evaluates expressions and solids at a place, which is a point or a stretch of a ray. Not for
/// several threads.
template <class T>
class Values {
public:
    explicit Values(const Shape& shape)
        : shape_(shape), variables_(shape.variable_count), registers_(shape.tapes.size()) {
        std::vector<T> parameters;
        for (const double parameter : shape.parameters) parameters.push_back(T(parameter));
        for (std::size_t i = 0; i < shape.tapes.size(); ++i) {
            eval::load_parameters<T>(shape.tapes[i], parameters, registers_[i]);
        }
    }

    void move_to(const std::array<T, 3>& place) {
        std::copy(place.begin(), place.end(), variables_.begin());
    }
    /// Of the first root.
    T expression(std::size_t tape) {
        T result{};
        eval::evaluate_loaded<T>(shape_.tapes[tape], variables_, std::span<T>(&result, 1),
                                 registers_[tape]);
        return result;
    }
    /// Not for a solid with loops.
    T solid(std::size_t number) {
        const Solid& node = shape_.solids[number];
        switch (node.what) {
            case Solid::What::formula:
                return outside_if_undefined(expression(node.source));
            case Solid::What::least:
                return numeric::min(solid(node.operands[0]), solid(node.operands[1]));
            case Solid::What::most:
                return numeric::max(solid(node.operands[0]), solid(node.operands[1]));
            case Solid::What::complement:
                return numeric::neg(solid(node.operands[0]));
            case Solid::What::blend:
                return blend(node);
            case Solid::What::loop:
                break;
        }
        return T(numeric::infinity);
    }

private:
    T blend(const Solid& node) {
        for (std::size_t i = 0; i < node.operands.size(); ++i) {
            const T value = as_operand(solid(node.operands[i]));
            variables_[graph::index(node.values[i])] = value;
        }
        std::array<T, 2> roots{};
        const eval::Tape& tape = shape_.tapes[node.source];
        eval::evaluate_loaded<T>(tape, variables_, std::span(roots).first(tape.roots.size()),
                                 registers_[node.source]);
        const T value = outside_if_undefined(roots[0]);
        if (tape.roots.size() < 2) return value;
        return outside_if_undefined(numeric::add(value, outside_if_undefined(roots[1])));
    }

    const Shape& shape_;
    std::vector<T> variables_;
    std::vector<std::vector<T>> registers_;
};

}  // namespace oracle
