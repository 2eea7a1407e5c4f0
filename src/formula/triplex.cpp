// SPDX-License-Identifier: MIT
#include "formula/triplex.h"

#include "formula/complex.h"

namespace formula {

using graph::Expr;

Triplex real_power(Triplex a, Expr n) {
    const Expr r = hypot(a.x, a.y, a.z);
    const Expr theta = n * acos(ratio(a.z, r));
    const Expr phi = n * atan2(a.y, a.x);
    const Expr radius = pow(r, n);
    return {radius * sin(theta) * cos(phi), radius * sin(theta) * sin(phi), radius * cos(theta)};
}

Triplex whole_power(Triplex a, int n) {
    const Expr rho = hypot(a.x, a.y);
    const Complex polar = whole_power(Complex{a.z, rho}, n);
    const Complex around = whole_power(Complex{ratio(a.x, rho), ratio(a.y, rho)}, n);
    return {polar.im * around.re, polar.im * around.im, polar.re};
}

}  // namespace formula
