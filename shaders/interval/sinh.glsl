#include "interval/interval.glsl"
#include "operator/sinh.glsl"

real2 interval_sinh(real2 a) {
    if (interval_is_empty(a)) return a;
    real2 inside = clamp(a, -80.0, 80.0);
    real2 r = real2(zs_sinh(inside.x), zs_sinh(inside.y));
    r = interval_widened(r, abs(r) * 7e-6);
    return real2(a.x < -80.0 ? zs_all().x : r.x, a.y > 80.0 ? zs_all().y : r.y);
}
