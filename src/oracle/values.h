// SPDX-License-Identifier: MIT
// The values of a shape's parts for one kind of numbers. Internal to the library.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "eval/operators.h"
#include "field/field.h"
#include "numeric/jet_operators.h"
#include "numeric/real.h"
#include "oracle/quaternion_jet.h"
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
    if (near == jet.value) return jet;
    J result(near);
    result.smooth = false;
    return result;
}

inline bool is_surely_above(double value, double minus_bound) { return value > -minus_bound; }
inline bool is_surely_above(const numeric::Interval& value, const numeric::Interval& minus_bound) {
    return value.lo > -minus_bound.lo;
}
template <numeric::AnyJet J>
bool is_surely_above(const J& value, const J& minus_bound) {
    return is_surely_above(value.value, minus_bound.value);
}

/// The same or anything above.
inline double or_more(double value) { return value; }
inline numeric::Interval or_more(const numeric::Interval& value) {
    return {value.lo, numeric::infinity, value.partial, true};
}
template <numeric::AnyJet J>
J or_more(const J& jet) {
    J result(or_more(jet.value));
    result.smooth = false;
    return result;
}

/// Evaluates expressions and solids at a place, which is a point or a stretch of a ray. Not for
/// several threads.
template <class T>
class Values {
public:
    explicit Values(const Shape& shape)
        : shape_(shape), variables_(shape.variable_count), registers_(shape.expressions.size()) {
        std::vector<T> parameters;
        for (const double parameter : shape.parameters) parameters.push_back(T(parameter));
        for (std::size_t i = 0; i < shape.expressions.size(); ++i) {
            eval::load_parameters<T>(shape.expressions[i].tape, parameters, registers_[i]);
        }
    }

    void move_to(const std::array<T, 3>& place) {
        std::copy(place.begin(), place.end(), variables_.begin());
    }
    /// Of the first root.
    T expression(std::size_t number) {
        set_cuts(shape_.expressions[number].cuts);
        return expression_of_cuts(number);
    }
    /// Not for one that is estimated. Of a quadratic iteration the largest |q|^2 less its
    /// bound, or something between 0 and that.
    T solid(std::size_t number) {
        set_cuts(shape_.solids[number].cuts);
        return solid_of_cuts(number);
    }
    /// A blend's value from those of its operands.
    T mix(const Solid& blend, std::span<const T> operands) {
        set_cuts(shape_.expressions[blend.source].cuts);
        return mix_of_cuts(blend, operands);
    }

    // For looking at each side of a jump by itself: what the variable of a cut may be, and then
    // values as it was set.

    /// The arguments of a cut.
    std::span<const T> arguments(const Cut& cut) {
        const std::size_t count = graph::arity(cut.op);
        run(cut.arguments, std::span(arguments_).first(count));
        return std::span(arguments_).first(count);
    }
    void set(graph::VariableId variable, const T& value) {
        variables_[graph::index(variable)] = value;
    }
    T expression_of_cuts(std::size_t number) {
        T result{};
        run(number, std::span<T>(&result, 1));
        return result;
    }
    T solid_of_cuts(std::size_t number) {
        const Solid& node = shape_.solids[number];
        const auto operand = [&](std::size_t i) { return solid_of_cuts(node.operands[i]); };
        switch (node.what) {
            case Solid::What::formula:
                return outside_if_undefined(expression_of_cuts(node.source));
            case Solid::What::least:
                return numeric::min(operand(0), operand(1));
            case Solid::What::most:
                return numeric::max(operand(0), operand(1));
            case Solid::What::complement:
                return numeric::neg(operand(0));
            case Solid::What::blend: {
                std::array<T, most_operands> values{};
                for (std::size_t i = 0; i < node.operands.size(); ++i) values[i] = operand(i);
                return mix_of_cuts(node, std::span(values).first(node.operands.size()));
            }
            case Solid::What::loop:
                return most_of_turns(shape_.loops[node.source]);
        }
        return T(numeric::infinity);
    }

private:
    static constexpr std::size_t most_operands = 4;

    void run(std::size_t expression, std::span<T> roots) {
        eval::evaluate_loaded<T>(shape_.expressions[expression].tape, variables_, roots,
                                 registers_[expression]);
    }
    void set_cuts(const std::vector<std::size_t>& cuts) {
        for (const std::size_t number : cuts) {
            const Cut& cut = shape_.cuts[number];
            set(cut.variable, eval::apply<T>(cut.op, arguments(cut)));
        }
    }
    /// Above 0 outside: what is outside after some turns stays so, whatever comes.
    T most_of_turns(const Loop& loop) {
        if (!loop.quadratic) return T(numeric::infinity);
        const QuadraticTurns& turns = *loop.quadratic;
        std::array<T, 9> roots{};
        run(turns.source, std::span(roots).first(2 * turns.size + 1));
        QuaternionJet<T> q(std::span<const T>(roots).first(turns.size));
        const QuaternionJet<T> constant(std::span<const T>(roots).subspan(turns.size, turns.size));
        const T minus_bound = outside_if_undefined(roots[2 * turns.size]);
        T most = q.norm();
        for (double turn = 0; turn < loop.limit; ++turn) {
            if (is_surely_above(most, minus_bound) || q.is_hopeless()) {
                return or_more(numeric::add(most, minus_bound));
            }
            q.turn(constant);
            most = numeric::max(most, q.norm());
        }
        return numeric::add(most, minus_bound);
    }
    T mix_of_cuts(const Solid& node, std::span<const T> operands) {
        for (std::size_t i = 0; i < operands.size(); ++i) {
            set(node.values[i], as_operand(operands[i]));
        }
        std::array<T, 2> roots{};
        const std::size_t count = shape_.expressions[node.source].tape.roots.size();
        run(node.source, std::span(roots).first(count));
        const T value = outside_if_undefined(roots[0]);
        if (count < 2) return value;
        return outside_if_undefined(numeric::add(value, outside_if_undefined(roots[1])));
    }

    const Shape& shape_;
    std::vector<T> variables_;
    std::array<T, graph::max_arity> arguments_{};
    std::vector<std::vector<T>> registers_;
};

}  // namespace oracle
