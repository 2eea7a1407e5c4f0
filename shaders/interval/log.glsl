#include "interval/interval.glsl"
#include "operator/log.glsl"

real2 interval_log(real2 a) {
    if (interval_is_empty(a) || a.y <= 0.0) return interval_nowhere();
    if (a.x <= 0.0) zs_breaks = true;
    real2 inside = clamp(a, 1e-30, 1e30);
    real2 r = real2(zs_log(inside.x), zs_log(inside.y));
    r = interval_widened(r, max(abs(r), 1.0) * 6e-7);
    return real2(a.x < 1e-30 ? zs_all().x : r.x, a.y > 1e30 ? zs_all().y : r.y);
}
