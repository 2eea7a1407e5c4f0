#include "operator/lesser.glsl"

// How much of a light is seen from o: on the way to it, the smallest of k * distance / travelled
// (O 6.3.3, K 112). Heuristic: the distance is a first-order estimate.
//
// With derivatives the walk goes by steps that are long but pass nothing, and what counts is where the
// distance has stopped falling and begun to grow: it looks back to where a parabola has its least between the
// two points. Where f grows from the start, or is steep without being small, nothing is passed by: it had its
// maximum there, or falls while the surface seems to be farther than before.
//
// Without, the nearest approach between two points is where the circles around them meet, of their
// distances (Aaltonen, "GPU-based clay simulation and ray-tracing tech in Claybook", GDC 2018, there for
// steps as long as the first distance), which takes the bands away. Steps by estimates, which are
// mostly half of the way, are longer than those and may pass what is thin.
real soft_shadow(real3 o, real3 l, real t0, real t1) {
    real k = frame.march.w;
    real least = 0.128 * frame.forward.w * frame.origin.w;
    int most = min(int(frame.march.x), 128), steps = 0;
    real t = t0, seen = 1.0;
    real before = 0.0, slope_before = 0.0, step = 0.0;
    // Of a look back: how far to go on from there.
    real onward = 0.0;
    bool going;
    zs_aside = true;
    field_start(o, l, t0, t1);
    do {
        Answer a = field(o, l, t);
        field_accept();
        bool hit = a.free <= 0.0;
        real h = zs_lesser(a.distance, 1e6);
        real slope = a.value == 0.0 ? 0.0 : a.rate * (h / a.value);
        // A sheet's f that grew up to its change of sign and falls behind it has a pole there.
        if (zs_has_edges) hit = hit && !(a.sheet && slope_before > 0.0 && a.value * a.rate < 0.0);
        bool steep = slope < 0.0 && (slope_before > 0.0 || (step > 0.0 && h > before));
        if (zs_has_rates) {
            bool looks_back = onward > 0.0;
            bool passed = slope_before < 0.0 && slope > 0.0;
            if (looks_back || (slope < 0.0 && !steep)) seen = zs_lesser(k * h / t, seen);
            real way = zs_greater(a.free, least);
            real nearer = passed ? step * slope / (slope - slope_before) : 0.0;
            step = looks_back ? onward : (passed ? -nearer : way);
            onward = passed ? nearer + way : 0.0;
            // From there on all was seen.
            if (looks_back) slope = 1.0;
        } else {
            real back = step > 0.0 ? (step * step + h * h - before * before) / (2.0 * step) : 0.0;
            back = zs_lesser(zs_greater(back, 0.0), zs_lesser(h, step));
            if (t > back && !(slope > 0.0) && !steep) {
                seen = zs_lesser(k * sqrt(h * h - back * back) / (t - back), seen);
            }
            real longer = zs_greater(zs_longer_steps, zs_knows_evenness ? 3.0 * zs_evenness : 0.0);
            step = zs_greater(zs_lesser(longer * a.free, zs_greater(h, least)), least);
        }
        if (hit) seen = 0.0;
        before = h;
        slope_before = slope;
        // What comes closer is looked at once more where it leaves the bounds.
        bool ahead = t < t1 && (t + step <= t1 || slope < 0.0);
        going = seen >= 0.01 && (ahead || step < 0.0) && ++steps < most;
        step = zs_lesser(step, t1 - t);
        t += step;
    } while (going);
    return seen < 0.01 ? 0.0 : seen * seen * (3.0 - 2.0 * seen);
}

real visibility(real3 p, real3 n, real3 l, real footprint) {
    real t0, t1;
    // Off the surface by some pixels, so that it does not darken itself.
    real3 o = p + n * max(4.0 * footprint, 6.4e-3 * frame.forward.w * frame.origin.w);
    if (!region_part(o, l, t0, t1)) return 1.0;
    return soft_shadow(o, l, t0, t1);
}
