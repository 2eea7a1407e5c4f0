// SPDX-License-Identifier: MIT
#include "analysis/rounding_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/operator_accuracy.h"
#include "eval/operators.h"
#include "numeric/jet_operators.h"

namespace analysis {
namespace {

using graph::Op;
using numeric::infinity;
using numeric::Interval;
using single = std::numeric_limits<float>;

constexpr double unit_roundoff = 0x1p-24;
/// What is smaller may become 0.
constexpr double least_normal = single::min();

Interval widened(const Interval& a, double by) {
    if (a.is_empty()) return a;
    return {numeric::add_down(a.lo, -by), numeric::add_up(a.hi, by), a.partial, a.jumps};
}

using Box = std::array<Interval, graph::max_arity>;

double width(const Interval& a) { return a.is_empty() ? 0 : numeric::add_up(a.hi, -a.lo); }

/// How far the operator's values may be from each other where its arguments are by the errors: by
/// the derivatives, where it has them and is continuous.
double slope_error(Op op, const Box& box, const std::array<double, graph::max_arity>& errors) {
    using D = numeric::Dual<Interval>;
    const std::size_t count = graph::arity(op);
    if (count > 3) return infinity;
    std::array<D, graph::max_arity> arguments;
    for (std::size_t i = 0; i < count; ++i) {
        arguments[i] = errors[i] > 0 ? D::variable(box[i], static_cast<int>(i)) : D(box[i]);
    }
    const D f = eval::apply<D>(op, arguments[0], arguments[1], arguments[2], arguments[3]);
    if (f.value.is_empty() || f.value.partial || f.value.jumps) return infinity;
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (!f.has_slope(static_cast<int>(i))) continue;
        const Interval& slope = f.gradient[i];
        if (slope.is_empty() || slope.partial) return infinity;
        sum = numeric::add_up(sum, numeric::mul_up(magnitude(slope), errors[i]));
    }
    return sum;
}

/// The same by what else is known of the operator: roots are steep at 0, but no steeper than that
/// of the error; a rounded number jumps by whole ones.
double modulus_error(Op op, double error) {
    if (op == Op::sqrt) return numeric::next_up(std::sqrt(error));
    if (op == Op::cbrt) return numeric::steps_up(1.5875 * std::cbrt(error), 8);
    if (op == Op::floor || op == Op::ceil) return 1 + std::ceil(error);
    return infinity;
}

class Operator {
public:
    Operator(const eval::Tape::Instruction& it, std::span<const Rounded> registers) : it_(it) {
        for (std::size_t i = 0; i < graph::arity(it.op); ++i) {
            const Rounded& a = registers[it.arguments[i]];
            exact_[i] = a.exact;
            errors_[i] = a.error;
            computed_[i] = widened(a.exact, a.error);
        }
    }

    Rounded result() const {
        const bool is_square = it_.op == Op::mul && it_.arguments[0] == it_.arguments[1];
        const Interval exact = is_square ? square(exact_[0]) : value_of(exact_);
        const auto none = std::ranges::any_of(errors_, [](double e) { return !(e < infinity); });
        if (none || exact.is_empty()) return {exact, infinity};
        const Interval computed = is_square ? square(computed_[0]) : value_of(computed_);
        // Rounding may have left the domain, or gone over a pole.
        if (computed.is_empty() || (computed.partial && !exact.partial)) return {exact, infinity};
        const Accuracy& accuracy = *accuracy_of(it_.op);
        if (!is_promised(accuracy, computed_)) return {exact, infinity};
        const double own =
            numeric::mul_up(accuracy.bound, largest_size(accuracy.unit, computed_[1], computed));
        return {exact, in_range(computed, numeric::add_up(handed_on(is_square, computed), own))};
    }

private:
    Interval value_of(const Box& box) const {
        return eval::apply<Interval>(it_.op, box[0], box[1], box[2], box[3]);
    }

    /// What the errors of the arguments make of the result.
    double handed_on(bool is_square, const Interval& computed) const {
        if (std::ranges::all_of(errors_, [](double e) { return e == 0; })) return 0;
        if (is_square) {
            return numeric::mul_up(2 * magnitude(computed_[0]), errors_[0]);
        }
        if (it_.op == Op::select_less &&
            (computed_[0].hi < computed_[1].lo || computed_[1].hi <= computed_[0].lo)) {
            return computed_[0].hi < computed_[1].lo ? errors_[2] : errors_[3];
        }
        const double by_slope =
            std::min(slope_error(it_.op, computed_, errors_), modulus_error(it_.op, errors_[0]));
        // No two values are farther apart than all of them: where it jumps, and at points.
        return std::min(by_slope, width(computed));
    }

    /// The error where numbers of that size exist.
    static double in_range(const Interval& computed, double error) {
        const Interval all = widened(computed, error);
        if (magnitude(all) > 0.99 * single::max()) return infinity;
        return mignitude(all) < least_normal ? numeric::add_up(error, least_normal) : error;
    }

    const eval::Tape::Instruction& it_;
    Box exact_{}, computed_{};
    std::array<double, graph::max_arity> errors_{};
};

/// A number of the double-precision side, handed over in single precision.
Rounded handed_over(const Interval& a) {
    if (a.is_empty() || magnitude(a) > single::max()) return {a, infinity};
    const bool same = a.is_point() && static_cast<double>(static_cast<float>(a.lo)) == a.lo;
    // Compilers may read a decimal number with an error in the last place.
    return {a, same ? 0 : numeric::mul_up(2 * unit_roundoff, magnitude(a)) + least_normal};
}

}  // namespace

RoundingErrors::RoundingErrors(const eval::Tape& tape, std::span<const double> parameters)
    : tape_(tape), registers_(tape.register_count), roots_(tape.roots.size()) {
    std::vector<Interval> loaded(parameters.begin(), parameters.end()), registers;
    eval::load_parameters<Interval>(tape, loaded, registers);
    for (std::size_t i = 0; i < tape.uniform_count(); ++i)
        registers_[i] = handed_over(registers[i]);
}

std::span<const Rounded> RoundingErrors::operator()(std::span<const Rounded> variables) {
    std::size_t next = tape_.uniform_count();
    for (const graph::VariableId id : tape_.variables) {
        registers_[next++] = variables[graph::index(id)];
    }
    for (const auto& instruction : std::span(tape_.instructions).subspan(tape_.independent)) {
        registers_[instruction.result] = Operator(instruction, registers_).result();
    }
    for (std::size_t i = 0; i < roots_.size(); ++i) roots_[i] = registers_[tape_.roots[i]];
    return roots_;
}

std::span<const Rounded> RoundingErrors::operator()(const Cell& cell, double position) {
    const auto sides = cell.sides();
    return (*this)(std::array{Rounded{sides[0], position}, Rounded{sides[1], position},
                              Rounded{sides[2], position}});
}

double rounding_error_bound(const eval::Tape& f, const Region& region,
                            std::span<const double> parameters, double position,
                            const Effort& effort) {
    RoundingErrors errors(f, parameters);
    return supremum_bound(region, effort, [&](const Cell& cell) {
        const Rounded over = errors(cell, position)[0];
        if (over.exact.is_empty()) return CellBounds{0, 0};
        const glm::dvec3 middle = cell.middle();
        const double at = errors(Cell{middle, middle}, position)[0].error;
        return CellBounds{over.error, std::isfinite(at) ? at : 0};
    });
}

double position_rounding(const Cell& cell) {
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        most = std::max({most, std::abs(cell.low[i]), std::abs(cell.high[i])});
    }
    return unit_roundoff * most;
}

}  // namespace analysis
