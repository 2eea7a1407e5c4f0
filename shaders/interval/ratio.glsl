#include "interval/div.glsl"

// a / b where |a| <= b is known, 0 for 0 / 0.
real2 interval_ratio(real2 a, real2 b) {
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_nowhere();
    if (b.x > 0.0) return clamp(interval_div(a, b), -1.0, 1.0);
    zs_breaks = true;
    return real2(a.x >= 0.0 ? 0.0 : -1.0, a.y <= 0.0 ? 0.0 : 1.0);
}
