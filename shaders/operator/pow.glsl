#include "operator/positive_pow.glsl"

// Negative bases have a value where the exponent is whole, and are NaN otherwise, also for an infinite one.
real zs_pow(real a, real b) {
    if (isnan(a) || isnan(b) || (a < 0.0 && (floor(b) != b || isinf(b)))) return zs_nan();
    if (b == 0.0 || a == 1.0) return 1.0;
    if (a == 0.0) {
        bool odd = floor(b) == b && floor(0.5 * b) != 0.5 * b;
        real zero = odd ? a : 0.0;
        return b > 0.0 ? zero : 1.0 / zero;
    }
    real p = zs_positive_pow(abs(a), b);
    return a > 0.0 || floor(0.5 * b) == 0.5 * b ? p : -p;
}
