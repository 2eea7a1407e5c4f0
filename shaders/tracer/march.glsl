#include "tracer/bracket.glsl"
#include "tracer/touch.glsl"

// Goes along a ray by the steps that the field allows, to the first surface. The field is asked in one
// place only, whatever it is asked for: drivers put the whole field there.

const int zs_miss = 0, zs_hit = 1, zs_unresolved = 2;

struct Trace {
    int status;
    real t;       // where: the depth of a hit, the end of a miss, the best guess otherwise
    int object;   // of a hit
    bool cap;     // the hit is where a solid is cut by the bounds, or the eye is inside
    int steps;
};

const int zs_marching = 0;   // towards the surface
const int zs_touching = 1;   // closer than a pixel
const int zs_bracketing = 2; // the surface has been crossed
const int zs_passing = 3;    // what was crossed is none: go on behind it
const int zs_entering = 4;   // a blind step has led into the domain: back to its edge

Trace trace(real3 o, real3 d, real t0, real t1) {
    Trace result = Trace(zs_unresolved, t0, -1, false, 0);
    field_start();
    int mode = zs_marching;
    real t = t0, before = t0;
    real edge_lo = t0, edge_hi = t0;
    Answer last;
    Bracket bracket;
    Touch touch;
    int undefined_before = 0;
    bool guess = false;
    int limit = int(frame.march.x);
    for (int i = 0; i < 2 * limit + 96; ++i) {
        Answer a = field(o + t * d, d);
        if (mode == zs_bracketing) {
            bracket_add(bracket, t, a);
            if (!bracket_is_small(bracket)) {
                t = bracket_guess(bracket);
                continue;
            }
            if (bracket_is_surface(bracket)) {
                result.status = zs_hit;
                result.t = 0.5 * (bracket.lo + bracket.hi);
                result.object = bracket.inside.object;
                return result;
            }
            t = bracket.hi;
            mode = zs_passing;
            continue;
        }
        if (mode == zs_passing) {
            field_accept();
            before = t;
            mode = zs_marching;
            continue;
        }
        if (zs_has_edges && mode == zs_entering) {
            if (zs_undefined < undefined_before) {
                edge_hi = t;
            } else {
                edge_lo = t;
            }
            bool close = edge_hi - edge_lo <= zs_relative_step * max(edge_hi, 1e-3);
            t = close ? edge_hi : 0.5 * (edge_lo + edge_hi);
            if (close) {
                undefined_before = 0;
                mode = zs_marching;
            }
            continue;
        }
        if (a.free <= 0.0) {
            if (result.steps == 0) return Trace(zs_hit, t0, a.object, true, 1);
            bracket = bracket_between(before, t, last, a);
            mode = zs_bracketing;
            t = bracket_is_small(bracket) ? t : bracket_guess(bracket);
            continue;
        }
        if (mode == zs_touching) {
            real asked = touch.next;
            bool done = touch_add(touch, a);
            before = touch.t;
            last = touch.answer;
            t = touch.next;
            if (!done) continue;
            if (touch_is_surface(touch)) {
                result.status = touch.t > t1 ? zs_miss : zs_hit;
                result.t = touch.t;
                result.object = touch.answer.object;
                return result;
            }
            t = asked;
            mode = zs_marching;
        }
        if (zs_has_edges && zs_undefined < undefined_before) {
            edge_lo = before;
            edge_hi = t;
            t = 0.5 * (edge_lo + edge_hi);
            mode = zs_entering;
            continue;
        }
        field_accept();
        undefined_before = zs_undefined;
        before = t;
        last = a;
        result.t = t;
        if (t >= t1 && guess) {
            result.status = zs_miss;
            return result;
        }
        if (++result.steps > limit) return result;
        real footprint = pixel_footprint(t);
        real epsilon = max(frame.march.z * footprint, 2.0 * zs_relative_step * max(t, 1e-3));
        // Near a pole the estimate is small as well, but there |f| grows.
        bool nearing = a.value * a.rate <= 0.0;
        if (nearing && a.free < epsilon && a.distance < max(0.5 * footprint, epsilon)) {
            touch = touch_at(t, a);
            t = touch.next;
            mode = zs_touching;
            continue;
        }
        guess = zs_guess;
        t += max(a.free, epsilon);
        if (t > t1) {
            // A proven step past the end proves a miss; after a guess the end is looked at too.
            if (!guess) {
                result.status = zs_miss;
                result.t = t1;
                return result;
            }
            t = t1;
        }
    }
    return result;
}
