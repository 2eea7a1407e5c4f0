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

/// re + i rho side, for a rho whose square is known: powers need no root.
struct Polar {
    Expr re, side, rho_squared;
};

Polar operator*(Polar a, Polar b) {
    return {a.re * b.re - a.side * b.side * a.rho_squared, a.re * b.side + a.side * b.re,
            a.rho_squared};
}

Polar whole_power(Polar a, int n) {
    if (n == 1) return a;
    const Polar half = whole_power(a, n / 2);
    const Polar square{half.re * half.re - half.side * half.side * a.rho_squared,
                       2.0 * half.re * half.side, a.rho_squared};
    return n % 2 == 0 ? square : square * a;
}

Polar polar_power(Triplex a, int n) {
    return whole_power(Polar{a.z, Expr(*a.z.graph, 1.0), a.x * a.x + a.y * a.y}, n);
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
    const Polar polar = polar_power(a, n);
    const Complex around = whole_power(Complex{ratio(a.x, rho), ratio(a.y, rho)}, n);
    const Expr aside = rho * polar.side;
    return {aside * around.re, aside * around.im, polar.re};
}

Expr whole_power_around(Triplex a, int n) { return abs(polar_power(a, n).side); }

}  // namespace formula
