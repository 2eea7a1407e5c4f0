// SPDX-License-Identifier: MIT
#include "analysis/derivative_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/spectral_norm.h"
#include "numeric/jet.h"

namespace analysis {
namespace {

using numeric::Dual;
using numeric::Interval;
using numeric::SecondOrder;

/// A formula with its parameters loaded, evaluated on numbers of one kind.
template <class T>
class Evaluator {
public:
    Evaluator(const eval::Tape& f, std::span<const double> parameters) : f_(f) {
        std::vector<T> loaded;
        for (const double parameter : parameters) loaded.push_back(T(parameter));
        eval::load_parameters<T>(f, loaded, registers_);
    }

    T operator()(const std::array<T, 3>& variables) {
        T value;
        eval::evaluate_loaded<T>(f_, variables, std::span<T>(&value, 1), registers_);
        return value;
    }

private:
    const eval::Tape& f_;
    std::vector<T> registers_;
};

/// A formula with derivatives up to an order, over cells and at points.
template <int order>
class JetEvaluator {
public:
    JetEvaluator(const eval::Tape& f, std::span<const double> parameters)
        : over_(f, parameters), at_(f, parameters) {}

    auto over(const Cell& cell) { return over_(variables<Interval>(cell.sides())); }
    auto at(glm::dvec3 point) { return at_(variables<double>({point.x, point.y, point.z})); }

private:
    template <class T>
    static std::array<numeric::Jet<T, 3, order>, 3> variables(const std::array<T, 3>& at) {
        using J = numeric::Jet<T, 3, order>;
        return {J::variable(at[0], 0), J::variable(at[1], 1), J::variable(at[2], 2)};
    }

    Evaluator<numeric::Jet<Interval, 3, order>> over_;
    Evaluator<numeric::Jet<double, 3, order>> at_;
};

bool breaks(const Interval& f) { return f.partial || f.jumps; }

/// True if an enclosure says nothing about the derivative at some point where f has a value: the
/// formula of the derivative may be undefined there.
bool has_gap(std::span<const Interval> derivatives, const Interval& f) {
    return std::ranges::any_of(
        derivatives, [&](const Interval& d) { return d.is_empty() || (d.partial && !f.partial); });
}

template <class T>
Symmetric<T> matrix(const std::array<T, 6>& hessian) {
    const auto entry = [&](int i, int j) {
        return hessian[static_cast<std::size_t>(numeric::triangle_place(i, j, 3))];
    };
    return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

/// The largest value that was found in a region; to be asked again only where more is possible.
class Sampled {
public:
    explicit Sampled(const Region& region) : region_(region) {}

    double largest() const { return largest_; }

    template <class Value>
    double at_middle(const Cell& cell, double upper, Value value) {
        if (upper <= largest_ || !contains(region_, cell.middle())) return 0;
        const double found = value(cell.middle());
        if (!std::isfinite(found)) return 0;
        largest_ = std::max(largest_, found);
        return found;
    }

private:
    Region region_;
    double largest_ = 0;
};

double gradient_on(const Dual<Interval>& f) {
    if (f.value.is_empty()) return 0;
    if (has_gap(f.gradient, f.value)) return numeric::infinity;
    const auto [dx, dy, dz] = f.gradient;
    return sqrt(square(dx) + square(dy) + square(dz)).hi;
}

/// A rough bound where even that is below `known`, which the supremum is above.
double second_derivative_on(const SecondOrder<Interval>& f, double known) {
    if (f.value.is_empty()) return 0;
    const bool kinks = std::ranges::any_of(f.gradient, &Interval::jumps);
    if (kinks || has_gap(f.gradient, f.value) || has_gap(f.hessian, f.value)) {
        return numeric::infinity;
    }
    const Symmetric<Interval> hessian = matrix(f.hessian);
    const double rough = frobenius_norm_bound(hessian);
    return rough <= known ? rough : spectral_norm_bound(hessian);
}

}  // namespace

bool may_break(const eval::Tape& f, const Region& region, std::span<const double> parameters,
               const Effort& effort) {
    Evaluator<Interval> evaluator(f, parameters);
    const double proven = supremum_bound(region, effort, [&](const Cell& cell) {
        return CellBounds{breaks(evaluator(cell.sides())) ? numeric::infinity : 0, 0};
    });
    return proven != 0;
}

double gradient_bound(const eval::Tape& f, const Region& region, std::span<const double> parameters,
                      const Effort& effort) {
    JetEvaluator<1> evaluator(f, parameters);
    Sampled sampled(region);
    return supremum_bound(region, effort, [&](const Cell& cell) {
        const double upper = gradient_on(evaluator.over(cell));
        const double lower = sampled.at_middle(cell, upper, [&](glm::dvec3 point) {
            const auto [dx, dy, dz] = evaluator.at(point).gradient;
            return numeric::hypot3(dx, dy, dz);
        });
        return CellBounds{upper, lower};
    });
}

double second_derivative_bound(const eval::Tape& f, const Region& region,
                               std::span<const double> parameters, const Effort& effort) {
    JetEvaluator<2> evaluator(f, parameters);
    Sampled sampled(region);
    return supremum_bound(region, effort, [&](const Cell& cell) {
        const double upper = second_derivative_on(evaluator.over(cell), sampled.largest());
        const double lower = sampled.at_middle(cell, upper, [&](glm::dvec3 point) {
            // The bound of a norm is above it by 2 % at most.
            return 0.98 * spectral_norm_bound(matrix(evaluator.at(point).hessian));
        });
        return CellBounds{upper, lower};
    });
}

}  // namespace analysis
