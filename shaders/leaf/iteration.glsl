// The answer of an iteration from its estimate. The distance itself is up to `reach` times as much (for
// escape-time sets Koebe's theorem leaves a factor of 4): told as the distance, that keeps a ray from
// ending where the step is short but the surface is not near. Where an escape-time iteration never
// escaped is inside, and nothing is known about how deep: the step out is heuristic, `distance` continues
// the estimate near the wall.
Answer iteration_answer(real estimate, bool inside, real reach, int object) {
    if (!inside) {
        // What is undefined is 0, and no estimate of a set that orbits escape from is below it.
        real s = estimate > 0.0 || (reach <= 1.0 && estimate < 0.0) ? estimate : 0.0;
        return Answer(s * frame.up.w, reach * s, s, 0.0, false, false, object);
    }
    zs_guess = true;
    real depth = estimate < -1e-30 ? estimate : -1e-30;
    return Answer(-0.125 * blind_step(), reach * depth, depth, 0.0, false, false, object);
}

// The same where a map that is no isometry lies between the point and the distance: the way is divided
// by the map's Lipschitz constant, a guess if that is unbounded. The distance is not: where the map
// stretches less, that would say that the surface is nearer than it is.
Answer distorted_answer(real estimate, bool inside, real inverse, real reach, int object) {
    Answer a = iteration_answer(estimate, inside, reach, object);
    real most = blind_step();
    if (!(inverse > 0.0)) zs_guess = true;
    a.free = inverse > 0.0 ? a.free * inverse : clamp(0.5 * a.free, -most, most);
    return a;
}
