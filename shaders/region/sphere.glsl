// The part [t0, t1] of the ray inside the bounding sphere; false if there is none.
bool region_part(real3 o, real3 d, out real t0, out real t1) {
    real3 c = frame.bounds_centre.xyz - o;
    real along = dot(c, d);
    real3 aside = c - along * d;  // exact even far away, where b^2 - c would cancel
    real square = frame.bounds_half.x * frame.bounds_half.x - dot(aside, aside);
    if (square <= 0.0) return false;
    real reach = sqrt(square);
    t0 = max(along - reach, 0.0);
    t1 = along + reach;
    return t1 > t0;
}

// The outward normal of the wall near a point on it.
real3 region_normal(real3 p) { return normalize(p - frame.bounds_centre.xyz); }

// How far the region is from a point, 0 inside.
real region_distance(real3 p) {
    return max(distance(p, frame.bounds_centre.xyz) - frame.bounds_half.x, 0.0);
}
