#include "tracer/stride.glsl"

// Between lo (outside) and hi (inside) the answer changes its sign; the bracket shrinks around that.
struct Bracket {
    real lo, hi;
    Answer outside, inside;
    real first_value;  // |f| at the outer end when the bracket was made
    real wall;         // how far ahead of the outer end f is known to jump
    int asked;         // how many answers it has got: first that at lo, then that at hi
};

Bracket bracket_between(real lo, real hi) {
    Bracket b;
    b.lo = lo;
    b.hi = hi;
    b.wall = zs_far;
    b.asked = 0;
    return b;
}

// Where to look next: at the outer end, the inner end, then by a secant of the estimated distances or,
// in turns, in the middle.
real bracket_guess(Bracket b) {
    if (b.asked == 1) return b.hi;
    real v = b.outside.distance, w = -b.inside.distance;
    bool secant = (b.asked & 1) == 0 && v < zs_far && w < zs_far && v + w > 0.0;
    return b.lo + (b.hi - b.lo) * (secant ? clamp(v / (v + w), 0.02, 0.98) : 0.5);
}

void bracket_add(inout Bracket b, real t, Answer a) {
    if (b.asked == 0) b.first_value = abs(a.value);
    ++b.asked;
    // The inner end counts as such even if the formula's rounding puts the change a little behind it.
    if (b.asked == 2 || (b.asked > 2 && a.free <= 0.0)) {
        b.hi = t;
        b.inside = a;
    } else {
        b.lo = t;
        b.outside = a;
        b.wall = zs_wall;
    }
}

// Both ends are known, and as close as single precision allows, or tried often enough.
bool bracket_is_small(Bracket b) {
    return b.asked > 1 && (b.hi - b.lo <= zs_relative_step * max(b.hi, 1e-3 * frame.origin.w) || b.asked >= 50);
}

// Tells a root from a pole or a jump, where a sheet's f changes its sign without being zero. At a pole
// |f| grows towards the change from both sides; at a jump the first-order distance stays far larger
// than the bracket. Heuristic, as it must be in floating point. For a solid every change is a wall.
bool bracket_is_surface(Bracket b) {
    if (b.inside.object < 0) return false;
    if (!b.inside.sheet) return true;
    real fa = b.outside.value, fb = b.inside.value;
    if (isinf(fa) || isinf(fb)) return false;
    bool pole = fa * b.outside.rate > 0.0 && fb * b.inside.rate < 0.0 && abs(fa) >= b.first_value;
    real nearest = min(abs(b.outside.distance), abs(b.inside.distance));
    // Where f is known to jump it is no noise that keeps it away from 0.
    bool walled = b.wall <= b.hi - b.lo + least_step(b.hi);
    real most = max(16.0 * (b.hi - b.lo), walled ? 0.0 : pixel_footprint(b.hi));
    bool jump = fa != 0.0 && !(nearest <= most);
    return !pole && !jump;
}
