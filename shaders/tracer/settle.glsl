#include "tracer/bracket.glsl"
#include "tracer/stride.glsl"
#include "tracer/touch.glsl"

// What has ended a march, and what comes of it.

const int zs_lost = 0;     // out of steps
const int zs_left = 1;     // past the end, without a hit
const int zs_crossed = 2;  // the answer has changed its sign
const int zs_near = 3;     // closer than a pixel
const int zs_entered = 4;  // a blind step has led into a domain
const int zs_passing = 5;  // what was crossed is no surface: to its other side

struct Settled {
    bool surface;   // whether there is a surface at t; otherwise the march goes on from t
    bool passing;   // whether something was near that the ray may pass by
    real t;
    Answer answer;  // of the surface
};

// From the march's last point `lo` and the point `hi` that ended it (equal if it is near), down to float
// accuracy. What comes no closer than `contact` is passed by. The field is asked in one place only, whatever for: drivers put the whole field there.
Settled settle(real3 o, real3 d, int event, real lo, real hi, int undefined_before, bool at_start,
               real contact) {
    // The formula itself is more exact than its coefficients along the ray.
    zs_aside = true;
    Bracket bracket = bracket_between(lo, hi);
    Touch touch;
    bool touching = false;
    real t = event == zs_entered ? 0.5 * (lo + hi) : lo;
    Answer a;
    for (int i = 0; i < min(int(frame.march.x) + 96, 160); ++i) {
        a = field(o, d, t);
        if (at_start) {
            certify_sides();
            return Settled(true, false, t, a);
        }
        if (event == zs_passing) {
            field_accept();
            // Some way off, since close to a pole everything looks near.
            return Settled(false, false, t + march_epsilon(t), a);
        }
        if (event == zs_entered) {
            if (zs_undefined < undefined_before) {
                hi = t;
            } else {
                lo = t;
            }
            if (hi - lo <= zs_relative_step * max(hi, 1e-3 * frame.origin.w)) return Settled(false, false, hi, a);
            t = 0.5 * (lo + hi);
            continue;
        }
        if (event == zs_near && a.free <= 0.0) {
            if (!touching) return Settled(true, false, lo, a);
            // Crossed while coming closer.
            event = zs_crossed;
            bracket = bracket_between(touch.t, t);
            bracket_add(bracket, touch.t, touch.answer);
        }
        if (event == zs_crossed) {
            bracket_add(bracket, t, a);
            if (bracket_is_small(bracket)) {
                real middle = 0.5 * (bracket.lo + bracket.hi);
                if (bracket_is_surface(bracket)) {
                    certify_sides();
                    return Settled(true, false, middle, bracket.inside);
                }
                event = zs_passing;
                t = bracket.hi;
            } else {
                t = bracket_guess(bracket);
            }
            continue;
        }
        if (!touching) {
            touch = touch_at(t, a);
            touching = true;
        } else if (touch_add(touch, a)) {
            if (touch_is_surface(touch)) {
                if (touch.answer.distance > contact) return Settled(false, true, lo, touch.answer);
                return Settled(true, false, touch.t, touch.answer);
            }
            return Settled(false, false, lo + max(touch.step, march_epsilon(lo)), touch.answer);
        }
        t = touch.t + touch.step;
    }
    return Settled(event == zs_near, false, t, a);
}
