#include "interval/interval.glsl"
#include "operator/pow.glsl"

// Between the powers of two numbers, for every exponent between: least and largest at corners.
real2 interval_positive_pow(real2 a, real2 b) {
    if (a.y > 1e6 || max(-b.x, b.y) > 64.0) return real2(0.0, zs_all().y);
    real4 p = real4(zs_pow(a.x, b.x), zs_pow(a.x, b.y), zs_pow(a.y, b.x), zs_pow(a.y, b.y));
    real4 error = (1.0 + max(-b.x, b.y) + abs(log(vec4(clamp(p, 1e-37, 1e37))))) * 5e-7;
    real4 low = p * (1.0 - error), high = p * (1.0 + error);
    real2 least = min(low.xy, low.zw), most = max(high.xy, high.zw);
    real2 r = interval_outward(real2(min(least.x, least.y), max(most.x, most.y)));
    return real2(max(r.x, 0.0), r.y);
}

real2 interval_pow(real2 a, real2 b) {
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_nowhere();
    if (a.x > 1e-30) return interval_positive_pow(a, b);
    bool whole = b.x == b.y && floor(b.x) == b.x;
    bool odd = mod(b.x, 2.0) == 1.0;
    if (whole && a.y < -1e-30) {
        real2 r = interval_positive_pow(-a.yx, b);
        return odd ? -r.yx : r;
    }
    if (b.x <= 0.0) return interval_everywhere();
    real2 up = interval_positive_pow(real2(1e-30, max(a.y, 1e-30)), b);
    if (floor(b.y) < b.x) {
        // No exponent is whole: undefined below 0.
        if (a.y < 0.0) return interval_nowhere();
        if (a.x < 0.0) zs_breaks = true;
        return real2(0.0, up.y);
    }
    if (!whole) return interval_everywhere();
    // Powers of both sides of 0.
    real2 down = interval_positive_pow(real2(1e-30, max(-a.x, 1e-30)), b);
    return real2(odd && a.x < 0.0 ? -down.y : 0.0, odd ? up.y : max(up.y, down.y));
}
