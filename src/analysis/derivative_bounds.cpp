// SPDX-License-Identifier: MIT
#include "analysis/derivative_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/spectral_norm.h"
#include "graph/extract.h"
#include "passes/differentiate.h"

namespace analysis {
namespace {

using numeric::Interval;

/// A tape with its parameters loaded, over cells and at points.
class Evaluator {
public:
    Evaluator(const eval::Tape& tape, std::span<const double> parameters) : tape_(tape) {
        const std::vector<Interval> intervals(parameters.begin(), parameters.end());
        eval::load_parameters<Interval>(tape, intervals, interval_registers_);
        eval::load_parameters<double>(tape, parameters, registers_);
        interval_roots_.resize(tape.roots.size());
        roots_.resize(tape.roots.size());
    }

    std::span<const Interval> over(const Cell& cell) {
        eval::evaluate_loaded<Interval>(tape_, cell.sides(), interval_roots_, interval_registers_);
        return interval_roots_;
    }
    std::span<const double> at(glm::dvec3 point) {
        const std::array variables{point.x, point.y, point.z};
        eval::evaluate_loaded<double>(tape_, variables, roots_, registers_);
        return roots_;
    }

private:
    const eval::Tape& tape_;
    std::vector<Interval> interval_registers_, interval_roots_;
    std::vector<double> registers_, roots_;
};

bool breaks(const Interval& f) { return f.partial || f.jumps; }

/// True if an enclosure says nothing about the derivative at some point where f has a value: the
/// formula of the derivative may be undefined there.
bool has_gap(std::span<const Interval> derivatives, const Interval& f) {
    return std::ranges::any_of(
        derivatives, [&](const Interval& d) { return d.is_empty() || (d.partial && !f.partial); });
}

double finite_or_zero(double x) { return std::isfinite(x) ? x : 0; }

CellBounds gradient_on(Evaluator& evaluator, const Cell& cell) {
    const std::span<const Interval> roots = evaluator.over(cell);
    if (roots[0].is_empty()) return {0, 0};
    CellBounds result;
    result.upper = has_gap(roots.subspan(1), roots[0]) ? numeric::infinity
                                                       : hypot3(roots[1], roots[2], roots[3]).hi;
    const std::span<const double> here = evaluator.at(cell.middle());
    result.lower = finite_or_zero(numeric::hypot3(here[1], here[2], here[3]));
    return result;
}

CellBounds second_derivative_on(Evaluator& evaluator, const Cell& cell) {
    const std::span<const Interval> roots = evaluator.over(cell);
    if (roots[0].is_empty()) return {0, 0};
    const std::span<const Interval> gradient = roots.subspan(1, 3), hessian = roots.subspan(4);
    const bool kinks = std::ranges::any_of(gradient, &Interval::jumps);
    CellBounds result;
    if (kinks || has_gap(gradient, roots[0]) || has_gap(hessian, roots[0])) {
        result.upper = numeric::infinity;
    } else {
        result.upper = spectral_norm_bound(Symmetric<Interval>{hessian[0], hessian[1], hessian[2],
                                                               hessian[3], hessian[4], hessian[5]});
    }
    const std::span<const double> h = evaluator.at(cell.middle()).subspan(4);
    // The bound is above the norm by 2 % at most.
    result.lower =
        0.98 *
        finite_or_zero(spectral_norm_bound(Symmetric<double>{h[0], h[1], h[2], h[3], h[4], h[5]}));
    return result;
}

}  // namespace

DerivativeTapes derivative_tapes(const graph::Graph& graph, graph::NodeId f) {
    // A graph of its own, so that many leaves take no longer than their parts together.
    graph::Extract part = extract(graph, std::array{f});
    graph::Graph& g = part.graph;
    const graph::NodeId value = part.roots[0];
    const std::array first = passes::gradient(g, value);
    const std::vector second = passes::gradients(g, first);
    const std::array all{value,        first[0],     first[1],     first[2],     second[0][0],
                         second[1][1], second[2][2], second[0][1], second[0][2], second[1][2]};
    const std::span<const graph::NodeId> roots(all);
    return {eval::make_tape(g, roots.first(1)), eval::make_tape(g, roots.first(4)),
            eval::make_tape(g, roots)};
}

bool may_break(const DerivativeTapes& tapes, const Region& region,
               std::span<const double> parameters, const Effort& effort) {
    Evaluator evaluator(tapes.value, parameters);
    const double proven = supremum_bound(region, effort, [&](const Cell& cell) {
        return CellBounds{breaks(evaluator.over(cell)[0]) ? numeric::infinity : 0, 0};
    });
    return proven != 0;
}

double gradient_bound(const DerivativeTapes& tapes, const Region& region,
                      std::span<const double> parameters, const Effort& effort) {
    Evaluator evaluator(tapes.gradient, parameters);
    return supremum_bound(region, effort,
                          [&](const Cell& cell) { return gradient_on(evaluator, cell); });
}

double second_derivative_bound(const DerivativeTapes& tapes, const Region& region,
                               std::span<const double> parameters, const Effort& effort) {
    Evaluator evaluator(tapes.hessian, parameters);
    return supremum_bound(region, effort,
                          [&](const Cell& cell) { return second_derivative_on(evaluator, cell); });
}

}  // namespace analysis
