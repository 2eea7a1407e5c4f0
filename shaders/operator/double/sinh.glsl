#include "operator/exp.glsl"

// Near 0 by the series, where the difference of exponentials cancels. Relative error of a few units in the
// last place.
real zs_sinh(real x) {
    real z = x * x;
    if (z < 1.0) {
        real p = 1.0 / 355687428096000.0lf;
        p = p * z + 1.0 / 1307674368000.0lf;
        p = p * z + 1.0 / 6227020800.0lf;
        p = p * z + 1.0 / 39916800.0lf;
        p = p * z + 1.0 / 362880.0lf;
        p = p * z + 1.0 / 5040.0lf;
        p = p * z + 1.0 / 120.0lf;
        p = p * z + 1.0 / 6.0lf;
        return x + x * z * p;
    }
    // In two halves, so that it overflows no earlier than it must.
    real e = zs_exp(0.5 * abs(x));
    real y = 0.5 * e * e - 0.5 / e / e;
    return x < 0.0 ? -y : y;
}
real zs_tanh(real x) {
    real a = abs(x);
    if (a < 0.5) {
        real s = zs_sinh(x);
        return s / sqrt(1.0 + s * s);
    }
    real y = 1.0 - 2.0 / (zs_exp(2.0 * a) + 1.0);
    return x < 0.0 ? -y : y;
}
