#include "interval/interval.glsl"
#include "operator/cbrt.glsl"

real2 interval_cbrt(real2 a) {
    if (interval_is_empty(a)) return a;
    return interval_outward(real2(zs_cbrt(a.x), zs_cbrt(a.y)));
}
