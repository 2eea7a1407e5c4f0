#include "interval/interval.glsl"
#include "operator/asin.glsl"

real2 interval_acos(real2 a) {
    if (interval_is_empty(a) || a.y < -1.0 || a.x > 1.0) return interval_nowhere();
    if (a.x < -1.0 || a.y > 1.0) zs_breaks = true;
    real2 r = real2(zs_acos(min(a.y, 1.0)), zs_acos(max(a.x, -1.0)));
    return interval_widened(r, real2(7e-7));
}
