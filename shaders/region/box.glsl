// The part [t0, t1] of the ray inside the bounding box; false if there is none.
bool region_part(real3 o, real3 d, out real t0, out real t1) {
    real3 safe = mix(d, real3(1e-20), equal(d, real3(0.0)));
    real3 c = (frame.bounds_centre.xyz - o) / safe;
    real3 h = frame.bounds_half.xyz / abs(safe);
    real3 enter = c - h, leave = c + h;
    t0 = max(max(enter.x, enter.y), max(enter.z, 0.0));
    t1 = min(leave.x, min(leave.y, leave.z));
    return t1 > t0;
}

// The outward normal of the wall near a point on it.
real3 region_normal(real3 p) {
    real3 q = (p - frame.bounds_centre.xyz) / frame.bounds_half.xyz;
    real3 a = abs(q);
    real most = max(a.x, max(a.y, a.z));
    return a.x == most ? real3(sign(q.x), 0.0, 0.0)
                       : (a.y == most ? real3(0.0, sign(q.y), 0.0) : real3(0.0, 0.0, sign(q.z)));
}

// How far the region is from a point, 0 inside.
real region_distance(real3 p) {
    return length(max(abs(p - frame.bounds_centre.xyz) - frame.bounds_half.xyz, 0.0));
}
