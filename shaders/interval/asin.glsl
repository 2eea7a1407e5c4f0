#include "interval/interval.glsl"
#include "operator/asin.glsl"

real2 interval_asin(real2 a) {
    if (interval_is_empty(a) || a.y < -1.0 || a.x > 1.0) return interval_nowhere();
    if (a.x < -1.0 || a.y > 1.0) zs_breaks = true;
    real2 r = real2(zs_asin(max(a.x, -1.0)), zs_asin(min(a.y, 1.0)));
    return interval_widened(r, abs(r) * 6e-7);
}
