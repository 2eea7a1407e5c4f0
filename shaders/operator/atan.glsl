#include "operator/atan_unit.glsl"

// The branch cut of atan2 is the negative x axis, where the angle is pi whatever the sign of a zero y.
real zs_atan(real x) {
    real a = abs(x);
    real y = a > 1.0 ? zs_half_pi - zs_atan_unit(1.0 / a) : zs_atan_unit(a);
    return x < 0.0 ? -y : y;
}
real zs_atan2(real y, real x) {
    if (isnan(x) || isnan(y)) return zs_nan();
    real a = abs(x), b = abs(y);
    real most = max(a, b);
    real part = most == 0.0 ? 0.0 : (isinf(most) ? (a == b ? 1.0 : 0.0) : min(a, b) / most);
    real angle = zs_atan_unit(part);
    if (b > a) angle = zs_half_pi - angle;
    if (x < 0.0) angle = 2.0 * zs_half_pi - angle;
    return y < 0.0 ? -angle : angle;
}
