#include "interval/interval.glsl"

real2 interval_mul(real2 a, real2 b) {
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_nowhere();
    return interval_of_four(a.xxyy * b.xyxy);
}

// By a number that is no infinity.
real2 interval_scaled(real2 a, real factor) {
    real2 r = a * factor;
    return interval_outward(factor < 0.0 ? r.yx : r);
}

real2 interval_square(real2 a) {
    if (interval_is_empty(a)) return a;
    real least = max(max(a.x, -a.y), 0.0), most = max(-a.x, a.y);
    real2 r = interval_outward(real2(least * least, most * most));
    return real2(max(r.x, 0.0), r.y);
}
