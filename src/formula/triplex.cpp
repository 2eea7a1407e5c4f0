// SPDX-License-Identifier: MIT
#include "formula/triplex.h"

#include "formula/complex.h"

namespace formula {

using graph::Expr;

namespace {

/// As passes::spell_out_lengths writes what is divided by a length twice, so that it is found
/// there.
Expr over_distance_to_axis(Expr number, Triplex a) {
    const Expr rho = hypot(a.x, a.y);
    return number * rho * (1.0 / max(rho * rho, 1e-36));
}

}  // namespace

Triplex real_power(Triplex a, Expr n) {
    const Expr r = hypot(a.x, a.y, a.z);
    const Expr theta = n * acos(ratio(a.z, r));
    const Expr phi = n * atan2(a.y, a.x);
    const Expr radius = pow(r, n);
    return {radius * sin(theta) * cos(phi), radius * sin(theta) * sin(phi), radius * cos(theta)};
}

Expr real_power_around(Triplex a, Expr n) {
    const Expr r = hypot(a.x, a.y, a.z);
    return over_distance_to_axis(abs(pow(r, n) * sin(n * acos(ratio(a.z, r)))), a);
}

Triplex whole_power(Triplex a, int n) {
    const Expr rho = hypot(a.x, a.y);
    const Complex polar = whole_power(Complex{a.z, rho}, n);
    const Complex around = whole_power(Complex{ratio(a.x, rho), ratio(a.y, rho)}, n);
    return {polar.im * around.re, polar.im * around.im, polar.re};
}

Expr whole_power_around(Triplex a, int n) {
    return over_distance_to_axis(abs(whole_power(Complex{a.z, hypot(a.x, a.y)}, n).im), a);
}

}  // namespace formula
