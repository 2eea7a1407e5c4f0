// SPDX-License-Identifier: MIT
#include "analysis/derivative_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/cell_derivatives.h"
#include "numeric/jet.h"

namespace analysis {
namespace {

using numeric::Interval;

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

}  // namespace

bool may_break(const eval::Tape& f, const Region& region, std::span<const double> parameters,
               const Effort& effort) {
    Evaluator<Interval> evaluator(f, parameters);
    const double proven = supremum_bound(region, effort, [&](const Cell& cell) {
        return CellBounds{may_break_on(evaluator(cell.sides())) ? numeric::infinity : 0, 0};
    });
    return proven != 0;
}

double gradient_bound(const eval::Tape& f, const Region& region, std::span<const double> parameters,
                      const Effort& effort) {
    JetEvaluator<1> evaluator(f, parameters);
    Sampled sampled(region);
    return supremum_bound(region, effort, [&](const Cell& cell) {
        const double upper = gradient_bound_on(evaluator.over(cell));
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
        const double upper = second_derivative_bound_on(evaluator.over(cell), sampled.largest());
        const double lower = sampled.at_middle(cell, upper, [&](glm::dvec3 point) {
            // The bound of a norm is above it by 2 % at most.
            return 0.98 * spectral_norm_bound(hessian_matrix(evaluator.at(point).hessian));
        });
        return CellBounds{upper, lower};
    });
}

}  // namespace analysis
