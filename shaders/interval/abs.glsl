#include "interval/interval.glsl"

real2 interval_abs(real2 a) {
    if (interval_is_empty(a)) return a;
    return real2(max(max(a.x, -a.y), 0.0), max(-a.x, a.y));
}
