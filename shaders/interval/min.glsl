#include "interval/interval.glsl"

real2 interval_min(real2 a, real2 b) {
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_nowhere();
    return min(a, b);
}
