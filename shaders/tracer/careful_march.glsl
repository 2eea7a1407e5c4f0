#include "tracer/settle.glsl"
#include "tracer/trace.glsl"

// Goes along a ray to the first surface, by the strides of the tracer that this is joined with, where
// answers are distances or estimates, or where f may be undefined, break off or change its sign without
// being zero. The loop that makes the strides is kept small, since many lanes go through it together;
// what is behind its end is asked afterwards.

// A surface that is near counts if the ray comes as close as this part of epsilon; else the ray goes on with
// that in place of epsilon, and by so much more with each step that it stays near.
const real zs_closest = 1.0 / 32.0, zs_patience = 1.02;

Trace trace(real3 o, real3 d, real t0, real t1) {
    Trace result = Trace(zs_unresolved, t0, -1, false, false, false, 0);
    field_start(o, d, t0, t1);
    int limit = int(frame.march.x);
    real t = t0, before = t0, free = 0.0, near_free = 0.0;
    int undefined_before = 0;
    real part = 1.0;       // of epsilon: less where the ray may pass something by
    bool grazing = false;  // what is near comes closer only behind the end
    // Once for most rays; again behind a pole, or from the edge of a domain.
    for (int round = 0; round <= limit; ++round) {
        int event = zs_lost;
        zs_aside = false;
        stride_start();
        while (result.steps < limit) {
            Answer a = stride_answer(o, d, t);
            if (stride_has_parted(a, t - before)) {
                ++result.steps;
                t = before + stride_back();
                continue;
            }
            if (a.free <= 0.0) {
                event = zs_crossed;
                break;
            }
            if (zs_has_edges && zs_undefined < undefined_before) {
                event = zs_entered;
                break;
            }
            field_accept();
            ++result.steps;
            real epsilon = march_epsilon(t);
            part = a.free > epsilon ? 1.0 : min(zs_patience * part, 1.0);
            epsilon *= part;
            before = t;
            near_free = a.free;
            free = max(a.free, min(epsilon, zs_wall + least_step(t)));
            // Near a pole the estimate is small as well, but there |f| grows.
            if (!grazing && a.free < epsilon && a.distance < epsilon && a.value * a.rate <= 0.0 &&
                a.object >= 0) {
                event = zs_near;
                certify_step(t, epsilon, 0.0, epsilon, zs_far);
                break;
            }
            real way = stride(free, epsilon);
            certify_step(t, stride_is_checked() ? a.free : way, a.free, epsilon, t1 - t);
            t += way;
            // A proven step past the end proves a miss; after a guess the end is looked at too.
            if (t > t1) {
                if ((!zs_guess && before + free > t1) || before >= t1) {
                    event = zs_left;
                    break;
                }
                t = t1;
            }
            if (zs_has_edges) undefined_before = zs_undefined;
        }
        result.t = before;
        if (event == zs_left) {
            result.status = zs_miss;
            return result;
        }
        if (event == zs_lost) {
            if (grazing) result.status = zs_miss;
            return result;
        }
        bool at_start = event == zs_crossed && result.steps == 0;
        certify_end();
        Settled settled = settle(o, d, event, before, t, undefined_before, at_start,
                                 part < 1.0 ? zs_far : zs_closest * march_epsilon(before));
        t = settled.t;
        if (settled.surface && t > t1) {
            // There may be another surface on the way.
            certify_passing();
            grazing = true;
            t = min(before + free, t1);
            continue;
        }
        if (settled.surface) {
            result.status = zs_hit;
            result.t = t;
            result.object = settled.answer.object;
            result.turned = settled.answer.turned;
            result.cap = at_start;
            return result;
        }
        if (settled.passing) {
            part = zs_closest;
            t += max(near_free, part * march_epsilon(t));
            continue;
        }
        certify_passing();
        before = t;
        if (zs_has_edges) undefined_before = 0;
    }
    return result;
}
