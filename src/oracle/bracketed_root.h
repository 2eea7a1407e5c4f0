// SPDX-License-Identifier: MIT
// A root between two values of different sign, by inverse quadratic interpolation where that is
// safe and bisection elsewhere (Chandrupatla, "A new hybrid quadratic/bisection algorithm for
// finding the zero of a nonlinear function without using derivatives", 1997). Not rigorous.
#pragma once

#include <algorithm>
#include <cmath>

namespace oracle {

/// The end with the smaller value of a bracket not longer than `tolerance`, or of the last one. f
/// has the values fa and fb, of different sign, at a and b.
template <class F>
double bracketed_root(F f, double a, double fa, double b, double fb, double tolerance) {
    double part = 0.5;
    for (int i = 0; i < 100; ++i) {
        const double t = a + part * (b - a), ft = f(t);
        double c = a, fc = fa;
        if ((ft > 0) != (fa > 0)) {
            c = b;
            fc = fb;
            b = a;
            fb = fa;
        }
        a = t;
        fa = ft;
        const double best = std::abs(fb) < std::abs(fa) ? b : a;
        const double least_part = 0.5 * tolerance / std::abs(b - a);
        if (fa == 0 || fb == 0 || !(least_part < 0.5)) return best;
        const double xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
        part = 0.5;
        if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi) {
            part = fa / (fb - fa) * fc / (fb - fc) +
                   (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
        }
        part = part > least_part ? std::min(part, 1 - least_part) : least_part;
    }
    return std::abs(fb) < std::abs(fa) ? b : a;
}

}  // namespace oracle
