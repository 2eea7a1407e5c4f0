// A leaf that is a polynomial along the ray. Its coefficients are those of s, which goes from -1 to 1 on
// the part of the ray that is looked at.
real zs_middle = 0.0, zs_half = 1.0;

// The first root of v + w r - k r^2 that is not negative, for v >= 0. Where v is 0, w may have the wrong
// sign.
real parabola_root(real v, real w, real k) {
    if (v == 0.0) return 0.0;
    real square = w * w + 4.0 * k * v;
    if (square < 0.0) return zs_far;
    real root = sqrt(square);
    // As a quotient where the difference would cancel.
    real over = w < 0.0 ? 2.0 * v : w + root;
    real under = w < 0.0 ? root - w : 2.0 * k;
    return under > 0.0 ? over / under : zs_far;
}

// The answer from f and df/ds at s, and from how far no root is, in s.
Answer polynomial_answer(real f, real rate, real bend, real way, int object) {
    if (isnan(f)) return answer_undefined(object);
    real v = abs(f);
    // How far a root is from here on either side, by a parabola, as if it were crossed at right angles.
    real estimate = v > 0.0 ? min(zs_half * v * inversesqrt(rate * rate + abs(bend) * v), zs_far) : 0.0;
    real s = min(zs_half * way, zs_far) / frame.march.y;
    rate /= zs_half;
    return f < 0.0 ? Answer(-s, -estimate, f, rate, false, false, object)
                   : Answer(s, estimate, f, rate, false, false, object);
}
