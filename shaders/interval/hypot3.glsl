#include "interval/abs.glsl"
#include "operator/hypot.glsl"

real2 interval_hypot3(real2 a, real2 b, real2 c) {
    if (interval_is_empty(a) || interval_is_empty(b) || interval_is_empty(c)) {
        return interval_nowhere();
    }
    a = interval_abs(a);
    b = interval_abs(b);
    c = interval_abs(c);
    real2 r = real2(zs_hypot3(a.x, b.x, c.x), zs_hypot3(a.y, b.y, c.y));
    r.x = isinf(r.x) ? max(max(a.x, b.x), c.x) : r.x;
    r = interval_widened(r, abs(r) * 4e-7 + 1e-15);
    return real2(max(r.x, 0.0), r.y);
}
