// The real cube root: a power of the magnitude, mended by a step of Newton's method.
real zs_cbrt(real x) {
    real a = abs(x);
    if (!(a > 0.0) || isinf(a)) return x;
    real y = exp2(log2(a) * (1.0 / 3.0));
    y -= (y - a / (y * y)) * (1.0 / 3.0);
    return x < 0.0 ? -y : y;
}
