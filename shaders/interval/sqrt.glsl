#include "interval/interval.glsl"
#include "operator/sqrt.glsl"

real2 interval_sqrt(real2 a) {
    if (interval_is_empty(a) || a.y < 0.0) return interval_nowhere();
    if (a.x < 0.0) zs_breaks = true;
    real2 r = interval_outward(real2(zs_sqrt(max(a.x, 0.0)), zs_sqrt(a.y)));
    return real2(max(r.x, 0.0), r.y);
}
