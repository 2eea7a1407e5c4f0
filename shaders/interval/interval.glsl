// Intervals [x, y] that enclose what an expression is somewhere in an interval of the ray. An end may be
// infinite on its own side; NaN is nowhere defined.

// Whether a value may be undefined or jump somewhere in the interval.
bool zs_breaks = false;

const real zs_largest = 3.4e38;
real2 zs_all() {
    return real2(-uintBitsToFloat(0x7f800000u), uintBitsToFloat(0x7f800000u));
}

bool interval_is_empty(real2 a) { return zs_may_be_empty && isnan(a.x); }

real2 interval_nowhere() {
    zs_breaks = true;
    return real2(zs_nan());
}

real2 interval_everywhere() {
    zs_breaks = true;
    return zs_all();
}

// Moved outwards, beyond an error of each end and whatever is flushed to 0.
real2 interval_widened(real2 r, real2 error) {
    if (interval_is_empty(r)) return r;
    r = real2(min(r.x, zs_largest), max(r.y, -zs_largest));
    return r + real2(-1.0, 1.0) * (error + 1e-37);
}

// By four times the rounding error of one operation.
real2 interval_outward(real2 r) { return interval_widened(r, abs(r) * 2.4e-7); }

// A number that was rounded on its way here.
real2 interval_about(real a) { return interval_outward(real2(a)); }

real2 interval_hull(real2 a, real2 b) { return real2(min(a.x, b.x), max(a.y, b.y)); }

// The least and the largest of four products or quotients; 0 times infinity is 0.
real2 interval_of_four(real4 p) {
    p = mix(p, real4(0.0), isnan(p));
    real2 least = min(p.xy, p.zw), most = max(p.xy, p.zw);
    return interval_outward(real2(min(least.x, least.y), max(most.x, most.y)));
}

// A coordinate along the ray.
real2 interval_along(real o, real d, real2 t) {
    real2 r = o + d * t;
    real room = (abs(o) + abs(d) * t.y) * 2.4e-7 + 1e-37;
    return real2(min(r.x, r.y) - room, max(r.x, r.y) + room);
}
