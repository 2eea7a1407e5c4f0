#include "interval/wave.glsl"
#include "operator/tan.glsl"

real2 interval_tan(real2 a) {
    if (interval_is_empty(a)) return a;
    if (!interval_has_wave(a) || interval_reaches(a, 1.57079633, 3.14159265)) {
        return interval_everywhere();
    }
    real2 r = real2(zs_tan(a.x), zs_tan(a.y));
    return interval_widened(r, (1.0 + r * r) * 3e-7);
}
