#include "operator/atan.glsl"

// By the arc tangent, of arguments that do not cancel. Outside of [-1, 1] NaN. Relative error of a few
// units in the last place, of acos absolute.
real zs_asin(real x) {
    if (!(abs(x) <= 1.0)) return zs_nan();
    return zs_atan2(x, sqrt((1.0 - x) * (1.0 + x)));
}
real zs_acos(real x) {
    if (!(abs(x) <= 1.0)) return zs_nan();
    return 2.0 * zs_atan2(sqrt(1.0 - x), sqrt(1.0 + x));
}
