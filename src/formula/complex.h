// SPDX-License-Identifier: MIT
// Complex numbers of graph nodes. Internal to the library.
#pragma once

#include "graph/build.h"

namespace formula {

struct Complex {
    graph::Expr re, im;
};

Complex operator*(Complex a, Complex b);
Complex operator/(Complex a, Complex b);
Complex inverse(Complex a);

/// a^n for n >= 1, by squaring.
Complex whole_power(Complex a, int n);

/// The principal value of a^n: the length to the power n, the angle (-pi to pi) times n.
Complex real_power(Complex a, graph::Expr n);

}  // namespace formula
