#include "interval/interval.glsl"
#include "operator/atan.glsl"

real2 interval_atan(real2 a) {
    if (interval_is_empty(a)) return a;
    real2 r = real2(zs_atan(clamp(a.x, -1e18, 1e18)), zs_atan(clamp(a.y, -1e18, 1e18)));
    return interval_widened(r, abs(r) * 5e-7);
}
