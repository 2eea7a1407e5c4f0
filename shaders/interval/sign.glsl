#include "interval/interval.glsl"
#include "operator/sign.glsl"

real2 interval_sign(real2 a) {
    if (interval_is_empty(a)) return a;
    real2 r = real2(zs_sign(a.x), zs_sign(a.y));
    if (r.x != r.y) zs_breaks = true;
    return r;
}
