#include "interval/interval.glsl"
#include "operator/sin.glsl"

// Where sine and cosine tell their argument, and an interval is no whole turn.
bool interval_has_wave(real2 a) {
    return max(-a.x, a.y) <= 50000.0 && a.y - a.x < 6.0;
}

// Whether place + n * turn may be in the interval for some whole n.
bool interval_reaches(real2 a, real place, real turn) {
    real room = 1e-6 * (1.0 + max(-a.x, a.y));
    return ceil((a.x - room - place) / turn) <= (a.y + room - place) / turn;
}

// From the values at the ends, and whether there is a minimum or a maximum between.
real2 interval_wave(real2 ends, bool least, bool most) {
    real2 r = real2(least ? -1.0 : min(ends.x, ends.y) - 2.5e-7,
                    most ? 1.0 : max(ends.x, ends.y) + 2.5e-7);
    return clamp(r, -1.0, 1.0);
}
