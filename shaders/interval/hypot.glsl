#include "interval/abs.glsl"
#include "operator/hypot.glsl"

// The squares of large numbers overflow, those of small ones vanish.
real2 interval_hypot(real2 a, real2 b) {
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_nowhere();
    a = interval_abs(a);
    b = interval_abs(b);
    real2 r = real2(zs_hypot(a.x, b.x), zs_hypot(a.y, b.y));
    r.x = isinf(r.x) ? max(a.x, b.x) : r.x;
    r = interval_widened(r, abs(r) * 4e-7 + 1e-15);
    return real2(max(r.x, 0.0), r.y);
}
