#include "interval/interval.glsl"
#include "operator/sinh.glsl"

real2 interval_tanh(real2 a) {
    if (interval_is_empty(a)) return a;
    real2 r = real2(zs_tanh(clamp(a.x, -1e18, 1e18)), zs_tanh(clamp(a.y, -1e18, 1e18)));
    return clamp(interval_widened(r, abs(r) * 5e-7), -1.0, 1.0);
}
