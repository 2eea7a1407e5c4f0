#include "interval/interval.glsl"
#include "operator/exp.glsl"

// Beyond 80 the exponential's error is not known: there it may be anything larger.
real2 interval_exp(real2 a) {
    if (interval_is_empty(a)) return a;
    real2 inside = clamp(a, -80.0, 80.0);
    real2 r = real2(zs_exp(inside.x), zs_exp(inside.y));
    r = interval_widened(r, r * (5e-7 + 8e-8 * abs(inside)));
    return real2(a.x < -80.0 ? 0.0 : max(r.x, 0.0), a.y > 80.0 ? zs_all().y : r.y);
}
