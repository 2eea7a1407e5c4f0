// GLSL's pow is undefined for negative bases. Here those have a value where the exponent is whole,
// and are NaN otherwise.
real zs_pow(real a, real b) {
    if (b == 0.0) return 1.0;
    if (a == 0.0) {
        bool odd = floor(b) == b && floor(0.5 * b) != 0.5 * b;
        real zero = odd ? a : 0.0;
        return b > 0.0 ? zero : 1.0 / zero;
    }
    real p = pow(abs(a), b);
    if (a > 0.0) return p;
    if (floor(b) != b) return isnan(a) || isnan(b) || !isinf(b) ? zs_nan() : p;
    return floor(0.5 * b) == 0.5 * b ? p : (isnan(a) ? a : -p);
}
