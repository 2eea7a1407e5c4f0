#include "tracer/trace.glsl"

// Along a ray through a field whose answers are balls that hold no surface, whichever way they are left:
// distances and estimates of them. One loop, and one place where the field is asked.

// A hit is closer than this part of `epsilon`.
real ball_epsilon(real part, real t) {
    return max(part * frame.march.z * pixel_footprint(t), 2.0 * zs_relative_step * max(t, 1e-3 * frame.origin.w));
}

// How far the surface is from where `free` is left, as it has shrunk from `before` on the way there.
real ball_rest(real free, real before, real way) {
    real rate = way > 0.0 ? (before - free) / way : 1.0;
    return free / clamp(rate, 0.1, 1.0);
}

Trace trace(real3 o, real3 d, real t0, real t1) {
    Trace result = Trace(zs_unresolved, t0, -1, false, false, false, 0);
    field_start(o, d, t0, t1);
    int limit = int(frame.march.x);
    real t = t0;
    real outside = t0, free = 0.0;  // the last point with a ball, and its radius
    real inside = zs_far;           // a point behind it that is in the solid
    while (result.steps < limit) {
        Answer a = field(o, d, t);
        ++result.steps;
        result.object = a.object;
        result.turned = a.turned;
        // Of an estimate the flat surface is twice as far, of a distance as far as it says.
        bool estimate = a.distance > a.free;
        real epsilon = ball_epsilon(!estimate ? 0.1 : (zs_knows_evenness ? 0.15 : 0.25), t);
        real way = t - outside, before = free;
        if (a.free > 0.0) {
            outside = t;
            free = a.free;
        } else {
            inside = t;
            result.cap = result.steps == 1;
        }
        bool near = a.free > 0.0 && a.free < epsilon;
        real rest = ball_rest(free, before, way);
        if (near || inside - outside < epsilon) {
            result.status = zs_hit;
            t = near ? min(outside + rest, min(inside, t1)) : 0.5 * (outside + inside);
            break;
        }
        // Rays go nearly to where the shrinking of the balls leads, and may pass what is smaller than the
        // part of the way outside of both balls (heuristic): by a distance within `epsilon` only, by an
        // estimate, which is mostly half of the way, within a pixel, and from everywhere as far as it can be
        // relied on; by as much as by a distance where what they may pass is as small.
        real most = free < pixel_footprint(t) ? 1.8 : 1.0;
        if (zs_knows_evenness) most = max(most, zs_evenness * (free < ball_epsilon(4.0, t) ? 4.0 : 2.2));
        if (!estimate) most = free < ball_epsilon(1.0, t) ? 4.0 : 1.0;
        t = outside + (a.free > 0.0 ? clamp((estimate ? 0.8 : 0.9) * rest, free, most * free) : free);
        if (t >= inside) t = 0.5 * (outside + inside);
        if (t > t1) {
            // After a guess the end is looked at too.
            if (!zs_guess || outside >= t1) {
                result.status = zs_miss;
                break;
            }
            t = t1;
        }
    }
    result.t = t;
    return result;
}
