#include "leaf/first_order_distance.glsl"

// A leaf that is a polynomial along the ray. Its coefficients are those of s, which goes from -1 to 1 on
// the part of the ray that is looked at.
real zs_middle = 0.0, zs_half = 1.0, zs_half_inverse = 1.0;

// What the coefficients and Horner's scheme may be off by, as a part of the sum of their sizes, which is
// made 1; heuristic. Where f is smaller, the formula itself is asked.
const real zs_polynomial_error = 5.0 * zs_relative_step;

// The first positive root of v + w r - k r^2, for v > 0.
real parabola_root(real v, real w, real k) {
    real square = w * w + 4.0 * k * v;
    if (square < 0.0) return zs_far;
    real root = sqrt(square);
    // As a quotient where the difference would cancel.
    real over = w < 0.0 ? 2.0 * v : w + root;
    real under = w < 0.0 ? root - w : 2.0 * k;
    return under > 0.0 ? over / under : zs_far;
}

// How far no root is, in s, where that is known: nothing is proven where f is rounded to 0, and beyond what the
// numbers hold.
real free_way(real way, real v, real b0) {
    if (isnan(v) || isnan(b0)) {
        zs_guess = true;
        return blind_step() * zs_half_inverse;
    }
    return v == 0.0 ? 0.0 : way;
}

real free_distance(real way) { return min(zs_half * way, zs_far) * frame.up.w; }

// The answer from f and its gradient at the point, and from how far along the ray no root is, in s.
Answer aside_answer(real f, real3 g, real rate, real way, int object) {
    real v = abs(f), s = free_distance(way), estimate = first_order_distance(v, g);
    return f < 0.0 ? Answer(-s, -estimate, f, rate, false, false, object)
                   : Answer(s, estimate, f, rate, false, false, object);
}

// The answer from f, df/ds and half of the second derivative at s, and from how far no root is, in s.
Answer polynomial_answer(real f, real rate, real bend, real way, int object) {
    real v = abs(f);
    // How far a root is from here on either side, by a parabola, as if it were crossed at right angles.
    real estimate = min(zs_half * v * inversesqrt(rate * rate + abs(bend) * v), zs_far);
    rate *= zs_half_inverse;
    real s = free_distance(way);
    return f < 0.0 ? Answer(-s, -estimate, f, rate, false, false, object)
                   : Answer(s, estimate, f, rate, false, false, object);
}
