#include "interval/interval.glsl"

real2 interval_ceil(real2 a) {
    if (interval_is_empty(a)) return a;
    real2 r = ceil(a);
    if (r.x != r.y) zs_breaks = true;
    return r;
}
