// Goes along the axis as long as the ball around its point covers the cone there. The points of the rays
// at the distance s from the eye are within sqrt((s - t)^2 + s t spread^2) of the axis' point at t, so
// that the ball of radius r proves them free from t to the root s where that is r. It begins at the region:
// far from an escape-time set the estimate is larger than the distance (of a unit ball beyond 5).
real2 cone_part(real3 o, real3 axis, real spread) {
    field_start(o, axis, 0.0, frame.bounds_centre.w);
    real cosine = 1.0 - 0.5 * spread * spread;
    real sine = spread * sqrt(1.0 - 0.25 * spread * spread);
    real t = region_distance(o);
    int limit = min(int(frame.march.x), 64);
    for (int i = 0; i < limit; ++i) {
        Answer a = field(o, axis, t);
        real r = a.free - 4.0 * zs_relative_step * t;
        if (zs_guess || r <= spread * t) break;
        real further = cosine * t + sqrt(r * r - sine * sine * t * t);
        bool slow = further - t < 0.25 * spread * t;
        t = further;
        if (slow || t > frame.bounds_centre.w) break;
    }
    return real2(t, zs_far);
}
