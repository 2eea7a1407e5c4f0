#include "operator/lesser.glsl"
#include "tracer/trace.glsl"

// Along a ray through a field whose answers are balls that hold no surface, whichever way they are left:
// distances and estimates of them. One loop with one end, and one place where the field is asked.

// How many times as far as the ball's radius a ray goes at most from its middle. Rays go nearly to where the
// shrinking of the balls leads, and may pass what is smaller than the part of the way outside of both balls
// (heuristic): by a distance within `epsilon` only, by an estimate, which is mostly half of the way, within a
// pixel, and from everywhere as far as it can be relied on; by as much as by a distance where what they may
// pass is as small.
real ball_reach(bool estimate, real free, real pixel, real epsilon, real least) {
    if (!estimate) return free < zs_greater(epsilon, least) ? 4.0 : 1.0;
    real most = free < pixel ? 1.8 : 1.0;
    if (!zs_knows_evenness) return most;
    bool close = free < zs_greater(4.0 * epsilon, least);
    return zs_greater(most, close ? zs_lesser(6.0 * zs_evenness, 4.0) : zs_lesser(3.0 * zs_evenness, 2.2));
}

Trace trace(real3 o, real3 d, real t0, real t1) {
    Trace result = Trace(zs_unresolved, t0, -1, false, false, false, 0);
    field_start(o, d, t0, t1);
    int limit = int(frame.march.x);
    real outside = t0, free = 0.0;  // the last point with a ball, and its radius
    real inside = zs_far;           // a point behind it that is in the solid
    bool going;
    // What is needed afterwards is kept in `result`: lanes that are done calculate on, and only what is
    // assigned is not assigned for them.
    do {
        real t = result.t;
        Answer a = field(o, d, t);
        ++result.steps;
        // Of an estimate the flat surface is twice as far, of a distance as far as it says.
        bool estimate = a.distance > a.free;
        real pixel = pixel_footprint(t), epsilon = frame.march.z * pixel;
        real least = 2.0 * zs_relative_step * zs_greater(t, 1e-3 * frame.origin.w);
        real closest = zs_greater((!estimate ? 0.1 : (zs_knows_evenness ? 0.13 : 0.25)) * epsilon, least);
        real way = t - outside, before = free;
        bool is_free = a.free > 0.0;
        outside = is_free ? t : outside;
        free = is_free ? a.free : free;
        inside = is_free ? inside : t;
        // How many radii the surface is away, as the radius has shrunk on the way here.
        real onward = zs_greater(way / zs_greater(before - free, 0.1 * way), 1.0);
        bool near = is_free && free < closest;
        real most = ball_reach(estimate, free, pixel, epsilon, least);
        real radii = zs_lesser(zs_greater((estimate ? 0.8 : 0.9) * onward, 1.0), most);
        real next = outside + (is_free ? radii * free : free);
        if (next >= inside) next = 0.5 * (outside + inside);
        if (near || inside - outside < closest) {
            result.status = zs_hit;
            result.object = a.object;
            result.turned = a.turned;
            result.cap = !near && result.steps == 1;
            next = near ? zs_lesser(outside + onward * free, inside) : 0.5 * (outside + inside);
        } else if (next > t1 && (!zs_guess || outside >= t1)) {
            // After a guess the end is looked at too.
            result.status = zs_miss;
        }
        result.t = zs_lesser(next, t1);
        going = result.status == zs_unresolved && result.steps < limit;
    } while (going);
    return result;
}
