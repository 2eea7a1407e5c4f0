#include "interval/interval.glsl"

real2 interval_floor(real2 a) {
    if (interval_is_empty(a)) return a;
    real2 r = floor(a);
    if (r.x != r.y) zs_breaks = true;
    return r;
}
