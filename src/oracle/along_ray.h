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

/// Evaluates along a ray, again and again. Not for several threads.
class AlongRay {
public:
    explicit AlongRay(const Shape& shape) : numbers_(shape), intervals_(shape), jets_(shape) {}

    void take(const Ray& ray) { ray_ = ray; }
    const Ray& ray() const { return ray_; }

    /// In double precision, without a proof.
    double near(Function function, double t);
    /// An enclosure of the values over t. That of a solid ends at +infinity where it may be
    /// undefined.
    numeric::Interval over(Function function, numeric::Interval t);
    RayJet jet_over(Function function, numeric::Interval t);

private:
    Ray ray_;
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
