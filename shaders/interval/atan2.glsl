#include "interval/interval.glsl"
#include "operator/atan.glsl"

// The angle of a box that neither holds the origin nor meets the cut is least and largest at corners.
real2 interval_atan2(real2 y, real2 x) {
    if (interval_is_empty(y) || interval_is_empty(x)) return interval_nowhere();
    if (x.x <= 0.0 && y.x <= 0.0 && y.y >= 0.0) {
        zs_breaks = true;
        return real2(-3.1415935, 3.1415935);
    }
    x = clamp(x, -1e18, 1e18);
    y = clamp(y, -1e18, 1e18);
    real4 p = real4(zs_atan2(y.x, x.x), zs_atan2(y.x, x.y), zs_atan2(y.y, x.x), zs_atan2(y.y, x.y));
    real2 least = min(p.xy, p.zw), most = max(p.xy, p.zw);
    return interval_widened(real2(min(least.x, least.y), max(most.x, most.y)), real2(1.6e-6));
}
