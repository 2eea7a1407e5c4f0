// SPDX-License-Identifier: MIT
// The functions of a shape along one ray, as numbers, as intervals and with derivatives. Internal
// to the library.
#pragma once

#include "numeric/jet.h"
#include "oracle/ray.h"
#include "oracle/values.h"

namespace oracle {

/// f, f' and f'' over a stretch of a ray.
using RayJet = numeric::SecondOrder<numeric::Interval, 1>;

/// Which function: a solid's value, or an expression.
struct Function {
    enum class What { solid, expression };
    What what = What::expression;
    std::size_t number = 0;
};

/// What an operator that may jump may be on its sides, up to three; together all its values.
class Sides {
public:
    Sides(std::initializer_list<numeric::Interval> list) {
        for (const numeric::Interval& side : list) add(side);
    }
    void add(const numeric::Interval& side) { list_[count_++] = side; }
    const numeric::Interval* begin() const { return list_.data(); }
    const numeric::Interval* end() const { return list_.data() + count_; }

private:
    std::array<numeric::Interval, 3> list_;
    std::size_t count_ = 0;
};
Sides sides_of(graph::Op op, std::span<const numeric::Interval> arguments);

/// Evaluates along a ray, again and again. Not for several threads.
class AlongRay {
public:
    explicit AlongRay(const Shape& shape)
        : shape_(shape), numbers_(shape), intervals_(shape), jets_(shape) {}

    void take(const Ray& ray) {
        ray_ = ray;
        beam_ = ray;
        is_ray_ = true;
    }
    /// Whether the latest that was taken is one ray.
    bool is_ray() const { return is_ray_; }
    const Ray& ray() const { return ray_; }
    /// Enclosures are then those of all rays of the beam.
    void take(const Beam& beam) {
        beam_ = beam;
        is_ray_ = false;
    }

    /// How far the points of the beam's rays are apart at distance 1, at most in each coordinate.
    double spread() const {
        double most = 0;
        for (const auto& part : beam_.direction) most = std::max(most, part.hi - part.lo);
        return most;
    }

    /// In double precision, without a proof. Only for a ray.
    double near(Function function, double t);
    /// An enclosure of the values over t. That of a solid ends at +infinity where it may be
    /// undefined.
    numeric::Interval over(Function function, numeric::Interval t);
    RayJet jet_over(Function function, numeric::Interval t);
    /// True if the function has one of few jumps somewhere in t, and all its values on each side of
    /// these, taken by itself, are `good`.
    template <class Good>
    bool on_each_side(Function function, numeric::Interval t, Good good) {
        if (cuts(function).empty()) return false;
        intervals_.move_to(place(t));
        int sides = 0;
        return visit_sides(function, 0, sides, good) && sides > 1;
    }

private:
    std::array<numeric::Interval, 3> place(numeric::Interval t) const;
    const std::vector<std::size_t>& cuts(Function function) const;
    template <class Good>
    bool visit_sides(Function function, std::size_t next, int& sides, Good good) {
        const std::vector<std::size_t>& list = cuts(function);
        if (next == list.size()) {
            return ++sides <= most_sides &&
                   good(function.what == Function::What::solid
                            ? intervals_.solid_of_cuts(function.number)
                            : intervals_.expression_of_cuts(function.number));
        }
        const Cut& cut = shape_.cuts[list[next]];
        for (const numeric::Interval& side : sides_of(cut.op, intervals_.arguments(cut))) {
            intervals_.set(cut.variable, side);
            if (!visit_sides(function, next + 1, sides, good)) return false;
        }
        return true;
    }

    static constexpr int most_sides = 16;
    const Shape& shape_;
    Ray ray_;
    Beam beam_;
    bool is_ray_ = true;
    Values<double> numbers_;
    Values<numeric::Interval> intervals_;
    Values<RayJet> jets_;
};

/// A piece of a ray with the values of a function at its ends.
struct Piece {
    double begin = 0, end = 0;
    numeric::Interval at_begin, at_end;

    double length() const { return end - begin; }
};

/// True if the function is defined and continuous on the piece whose jet this is, and its slope is
/// bounded.
bool is_continuous_with_slope(const RayJet& jet);
/// True if the function moreover grows or falls all along.
bool is_monotone(const RayJet& jet);

/// The function's values over the piece: what its jet says, as far as it can be made narrower by
/// the values at the ends with the bounds of the slope (Piyavskii 1972) and of the second
/// derivative (the distance of a function from its chord). Rigorous.
numeric::Interval values_on(const Piece& piece, const RayJet& jet);

}  // namespace oracle
