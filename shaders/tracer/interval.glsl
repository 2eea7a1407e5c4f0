#include "interval/enclosure.glsl"
#include "tracer/settle.glsl"
#include "tracer/trace.glsl"

// Goes along a ray to the first surface by halving (Mitchell, "Robust Ray Intersection with Interval
// Arithmetic", 1990; Knoll et al., "Fast Ray Tracing of Arbitrary Implicit Surfaces with Interval and
// Affine Arithmetic", 2009): from the near end, a part of the ray is left behind where the field's
// enclosure proves that there is no surface, and halved where it does not, until the derivative proves
// that there is at most one, or the part is a small piece of a pixel. Without a stack: level and number
// of a part say what is next.

const int zs_most_halvings = 23;

// The part [x, y] of the ray that is a number of parts of 2^-level.
real2 ray_part(real t0, real t1, int level, int number) {
    real share = uintBitsToFloat(uint(127 - level) << 23);
    return t0 + (t1 - t0) * (share * real2(number, number + 1));
}

// A quarter of what counts as near, as far as single precision allows.
bool part_is_smallest(real2 part, int level) {
    real least = max(0.25 * march_epsilon(part.x), 4.0 * zs_relative_step * max(part.y, 1e-3 * frame.origin.w));
    return part.y - part.x <= least || level == zs_most_halvings;
}

// What the field at both ends of a part says that may hold a surface; the surface, if there is one.
Settled settle_part(real3 o, real3 d, real2 part, real t0, bool smallest) {
    Answer first, second;
    field_forget();
    // A bound that compilers cannot see keeps the field in one place.
    for (int i = 0; i < min(int(frame.march.x) + 1, 2); ++i) {
        second = field(o, d, i == 0 ? part.x : part.y);
        if (i > 0) break;
        first = second;
        field_accept();
    }
    bool at_start = first.free <= 0.0 && part.x <= t0;
    // Behind a pole the distance grows while |f| falls.
    bool pole = second.distance > first.distance && abs(second.value) < abs(first.value);
    // Exactly on a sheet no side can be told.
    bool near = smallest || first.value == 0.0;
    int event = zs_lost;
    if (first.free <= 0.0) {
        // Rounding: inside, and so far nothing was.
        part = real2(max(2.0 * part.x - part.y, t0), part.x);
        event = zs_crossed;
    } else if (second.free <= 0.0) {
        event = zs_crossed;
    } else if (near && !pole && first.distance < march_epsilon(part.x) &&
               first.value * first.rate <= 0.0 && first.object >= 0) {
        part.y = part.x;
        event = zs_near;
    }
    if (event == zs_lost) return Settled(false, false, part.y, first);
    return settle(o, d, event, part.x, part.y, 0, at_start, zs_far);
}

Trace trace(real3 o, real3 d, real t0, real t1) {
    Trace result = Trace(zs_unresolved, t0, -1, false, false, false, 0);
    field_start(o, d, t0, t1);
    int limit = int(frame.march.x);
    int level = 0, number = 0;
    // Once for most rays; again behind what was no surface.
    for (int round = 0; round <= limit; ++round) {
        bool found = false, smallest = false;
        real2 part = real2(t0);
        while (result.steps < limit) {
            ++result.steps;
            part = ray_part(t0, t1, level, number);
            Enclosure e = enclose(o, d, part);
            if (!(e.value.x > 0.0)) {
                smallest = part_is_smallest(part, level);
                found = smallest || e.value.y <= 0.0 || e.rate.x > 0.0 || e.rate.y < 0.0;
                if (found) break;
                ++level;
                number *= 2;
                continue;
            }
            // What has no intervals may have guessed.
            certify_step(part.x, part.y - part.x, zs_far, 0.0, zs_far);
            ++number;
            int up = min(findLSB(number), level);
            number >>= up;
            level -= up;
            if (level == 0) break;
        }
        result.t = part.x;
        if (found) {
            certify_end();
            Settled settled = settle_part(o, d, part, t0, smallest);
            if (settled.surface) {
                result.status = settled.t > t1 ? zs_miss : zs_hit;
                result.t = settled.t;
                result.object = settled.answer.object;
                result.turned = settled.answer.turned;
                result.cap = settled.answer.free <= 0.0 && part.x <= t0 && settled.t <= t0;
                return result;
            }
            certify_passing();
            ++number;
            int up = min(findLSB(number), level);
            number >>= up;
            level -= up;
        }
        if (level == 0 && number == 1) {
            result.status = zs_miss;
            return result;
        }
        if (!found) return result;
    }
    return result;
}
