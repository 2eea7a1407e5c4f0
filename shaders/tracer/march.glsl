#include "tracer/stride.glsl"
#include "tracer/trace.glsl"

// Goes along a ray to the first surface, by the strides of the tracer that this is joined with, and down
// to float accuracy: for fields whose answers all have a derivative along the ray and change their sign at
// surfaces only. All in one loop with one question to the field and few numbers that live from turn to
// turn: lanes go through it together, and what is in a branch costs all of them.

// A ray that comes closer so often without crossing touches: at a root of order n Newton's steps leave
// 1 - 1 / n of the way.
const int zs_most_near = 40;

Trace trace(real3 o, real3 d, real t0, real t1) {
    zs_aside = false;
    field_start(o, d, t0, t1);
    stride_start();
    int limit = int(frame.march.x), steps = 0, near_steps = 0, status;
    // The latest point outside, and the nearest inside.
    real outer = t0, inner = zs_far;
    real t = t0;
    Answer a;
    bool at_start, touched, going;
    do {
        a = stride_answer(o, d, t);
        bool inside = a.free <= 0.0;
        bool parted = near_steps == 0 && stride_has_parted(a, t - outer);
        at_start = inside && steps == 0;
        ++steps;
        real least = least_step(t), epsilon = march_epsilon(t);
        // How far the surface seems to be along the ray, ahead or, from inside, behind: Newton's step. Who
        // passes by closely is not near: there the derivative vanishes before f.
        real newton = a.value == 0.0 ? 0.0 : abs(a.value / a.rate);
        bool close = !inside && a.free < epsilon && newton < epsilon, falls = a.value * a.rate <= 0.0;
        bool near = close && falls && near_steps >= 0;
        touched = near && near_steps >= zs_most_near;
        bool passed = false;
        real least_way = near ? newton : epsilon;
        least_way = min(least_way, zs_wall + least);
        if (near) {
            ++near_steps;
        } else if (near_steps != 0) {
            // Newton's steps have led past the least |f|, or no farther: back, and on by proven steps.
            bool searching = !inside && inner == zs_far;
            touched = searching && object_is_zero(a.object, o + t * d, position_error(t));
            passed = searching && !touched && !falls && near_steps > 0;
            near_steps = passed || a.free < epsilon ? -1 : 0;
            if (close) least_way = epsilon / 16.0;
        }
        real way = max(a.free, least_way);
        if (near_steps == 0) way = stride(way, epsilon);
        real next = t + way;
        // A proven step past the end proves a miss; otherwise the end is looked at too.
        bool left = inner == zs_far && next > t1 && ((!zs_guess && t + a.free > t1) || t >= t1);
        next = min(next, t1);
        if (passed) {
            next = outer;
            left = false;
        } else if (parted) {
            next = outer + stride_back();
        } else if (inside) {
            inner = t;
            next = t - newton;
        } else {
            if (inner == zs_far) {
                field_accept();
                certify_step(t, stride_is_checked() ? a.free : way, a.free, epsilon, t1 - t);
            }
            outer = t;
        }
        bool crossed = inner < zs_far;
        // Newton's steps within the bracket, and every fourth halves it.
        if (crossed && !(next > outer && next < inner && (steps & 3) != 0)) next = 0.5 * (outer + inner);
        bool found = at_start || inner - outer <= least || ((near || crossed) && newton <= least) ||
                     touched;
        status = found ? zs_hit : (left ? zs_miss : zs_unresolved);
        going = status == zs_unresolved && steps < limit;
        if (going) t = next;
    } while (going);
    if (inner < zs_far) certify_sides();
    return Trace(status, t, a.object, a.turned, at_start, !touched, steps);
}
