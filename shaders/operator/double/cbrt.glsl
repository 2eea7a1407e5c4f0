#include "operator/exp.glsl"
#include "operator/log.glsl"

// The real cube root: a power of the magnitude, mended by a step of Newton's method.
real zs_cbrt(real x) {
    real a = abs(x);
    if (!(a > 0.0) || isinf(a)) return x;
    real y = zs_exp(zs_log(a) / 3.0lf);
    y -= (y - a / (y * y)) / 3.0lf;
    return x < 0.0 ? -y : y;
}
