#include "interval/abs.glsl"
#include "operator/cosh.glsl"

real2 interval_cosh(real2 a) {
    if (interval_is_empty(a)) return a;
    a = interval_abs(a);
    real2 inside = min(a, 80.0);
    real2 r = real2(zs_cosh(inside.x), zs_cosh(inside.y));
    r = interval_widened(r, abs(r) * 7e-6);
    return real2(max(r.x, 1.0), a.y > 80.0 ? zs_all().y : r.y);
}
