#include "interval/interval.glsl"

real2 interval_div(real2 a, real2 b) {
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_nowhere();
    if (b.x > 0.0 || b.y < 0.0) return interval_of_four(a.xxyy / b.xyxy);
    // At the end of the divisor is a pole: all else is on one side of it.
    if (b.x == 0.0 && b.y > 0.0 && a.x >= 0.0) {
        zs_breaks = true;
        return real2(max(interval_outward(real2(a.x / b.y)).x, 0.0), zs_all().y);
    }
    if (b.x == 0.0 && b.y > 0.0 && a.y <= 0.0) {
        zs_breaks = true;
        return real2(zs_all().x, min(interval_outward(real2(a.y / b.y)).y, 0.0));
    }
    return interval_everywhere();
}
