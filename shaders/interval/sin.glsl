#include "interval/wave.glsl"

real2 interval_sin(real2 a) {
    if (interval_is_empty(a)) return a;
    if (!interval_has_wave(a)) return real2(-1.0, 1.0);
    return interval_wave(real2(zs_sin(a.x), zs_sin(a.y)),
                         interval_reaches(a, -1.57079633, 6.28318531),
                         interval_reaches(a, 1.57079633, 6.28318531));
}
