// SPDX-License-Identifier: MIT
#include "oracle/along_ray.h"

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

using numeric::Interval;

template <class T>
T value_of(Values<T>& values, Function function) {
    return function.what == Function::What::solid ? values.solid(function.number)
                                                  : values.expression(function.number);
}

bool is_finite(const Interval& a) { return std::isfinite(a.lo) && std::isfinite(a.hi); }

/// What both enclosures of the same values leave.
Interval narrowed(const Interval& a, const Interval& b) {
    const double lo = std::max(a.lo, b.lo), hi = std::min(a.hi, b.hi);
    return lo <= hi ? Interval{lo, hi, a.partial, a.jumps} : a;
}

Interval slope_of(const RayJet& jet) { return jet.has_slope(0) ? jet.slope(0) : Interval(0.0); }

/// From the ends f can go no faster than its slope lets it. Where that is of one sign, the ends are
/// the extrema.
Interval between_slopes(const Piece& piece, const Interval& slope) {
    const Interval ends = hull(piece.at_begin, piece.at_end);
    if (slope.lo >= 0 || slope.hi <= 0) return ends;
    const Interval low(slope.lo), high(slope.hi), length = Interval(piece.end) - piece.begin;
    const Interval steepness = high - low, reach = low * high * length;
    const Interval least =
        (high * Interval(piece.at_begin.lo) - low * Interval(piece.at_end.lo) + reach) / steepness;
    const Interval most =
        (high * Interval(piece.at_end.hi) - low * Interval(piece.at_begin.hi) - reach) / steepness;
    return {std::min(least.lo, ends.lo), std::max(most.hi, ends.hi)};
}

/// A function leaves its chord by (t - begin)(end - t) / 2 times a value of -f''.
Interval around_chord(const Piece& piece, const Interval& bend) {
    const Interval length = Interval(piece.end) - piece.begin;
    const Interval eighth = square(length) * 0.125;
    return hull(piece.at_begin, piece.at_end) - bend * Interval{0, eighth.hi};
}

}  // namespace

Sides sides_of(graph::Op op, std::span<const Interval> arguments) {
    const Interval whole = eval::apply(op, arguments);
    if (!whole.jumps || whole.is_empty()) return {whole};
    const bool defined = std::ranges::none_of(arguments, &Interval::partial);
    const bool continuous = std::ranges::none_of(arguments, &Interval::jumps);
    if (!defined || !continuous) return {whole};
    if (op == graph::Op::select_less) return {arguments[2], arguments[3]};
    if (op == graph::Op::atan2) {
        const Interval &y = arguments[0], &x = arguments[1];
        if (!(y.lo < 0 && y.hi >= 0)) return {whole};
        return {atan2(Interval{0, y.hi}, x), atan2(Interval{y.lo, numeric::next_down(0)}, x)};
    }
    if (whole.hi - whole.lo > 2) return {whole};
    Sides sides{};
    for (double step = whole.lo; step <= whole.hi; ++step) sides.add(step);
    return sides;
}

std::array<Interval, 3> AlongRay::place(Interval t) const {
    std::array<Interval, 3> place;
    for (int i = 0; i < 3; ++i) {
        place[static_cast<std::size_t>(i)] =
            Interval(beam_.origin[i]) + beam_.direction[static_cast<std::size_t>(i)] * t;
    }
    return place;
}

const std::vector<std::size_t>& AlongRay::cuts(Function function) const {
    return function.what == Function::What::solid ? shape_.solids[function.number].cuts
                                                  : shape_.expressions[function.number].cuts;
}

double AlongRay::near(Function function, double t) {
    const glm::dvec3 p = ray_.at(t);
    numbers_.move_to({p.x, p.y, p.z});
    return value_of(numbers_, function);
}

Interval AlongRay::over(Function function, Interval t) {
    intervals_.move_to(place(t));
    return value_of(intervals_, function);
}

RayJet AlongRay::jet_over(Function function, Interval t) {
    const std::array<Interval, 3> at = place(t);
    std::array<RayJet, 3> place;
    for (std::size_t i = 0; i < 3; ++i) place[i] = RayJet::along(at[i], beam_.direction[i]);
    jets_.move_to(place);
    return value_of(jets_, function);
}

bool is_continuous_with_slope(const RayJet& jet) {
    const Interval& value = jet.value;
    if (value.is_empty() || value.partial || value.jumps) return false;
    const Interval slope = slope_of(jet);
    return !slope.is_empty() && !slope.partial && is_finite(slope);
}

bool is_monotone(const RayJet& jet) {
    if (!is_continuous_with_slope(jet)) return false;
    const Interval slope = slope_of(jet);
    return slope.lo > 0 || slope.hi < 0;
}

Interval values_on(const Piece& piece, const RayJet& jet) {
    if (!is_continuous_with_slope(jet)) return jet.value;
    if (!is_finite(piece.at_begin) || !is_finite(piece.at_end)) return jet.value;
    if (piece.at_begin.partial || piece.at_end.partial) return jet.value;
    Interval values = narrowed(jet.value, between_slopes(piece, slope_of(jet)));
    if (!jet.smooth) return values;
    const Interval bend = jet.has_bend(0) ? jet.bend(0) : Interval(0.0);
    if (bend.is_empty() || bend.partial || !is_finite(bend)) return values;
    return narrowed(values, around_chord(piece, bend));
}

}  // namespace oracle
