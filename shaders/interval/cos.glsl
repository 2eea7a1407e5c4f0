#include "interval/wave.glsl"

real2 interval_cos(real2 a) {
    if (interval_is_empty(a)) return a;
    if (!interval_has_wave(a)) return real2(-1.0, 1.0);
    return interval_wave(real2(zs_cos(a.x), zs_cos(a.y)),
                         interval_reaches(a, 3.14159265, 6.28318531),
                         interval_reaches(a, 0.0, 6.28318531));
}
