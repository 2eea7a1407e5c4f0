#include "interval/interval.glsl"

// c where a < b, else d.
real2 interval_select_less(real2 a, real2 b, real2 c, real2 d) {
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_nowhere();
    if (a.y < b.x) return c;
    if (a.x >= b.y) return d;
    zs_breaks = true;
    if (interval_is_empty(c)) return d;
    return interval_is_empty(d) ? c : interval_hull(c, d);
}
