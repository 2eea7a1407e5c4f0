#include "leaf/first_order_distance.glsl"

// The answer of a formula from its value and gradient. The sign is that of f; outside of its domain
// is outside.
Answer formula_answer(real f, real3 g, real3 d, real3 bounds, int object) {
    if (zs_has_edges && isnan(f)) return answer_undefined(object);
    real v = abs(f);
    real rate = dot(g, d);
    real estimate = first_order_distance(v, g);
    real s = formula_step(v, f < 0.0 ? -rate : rate, estimate, bounds) * frame.up.w;
    // Where f is rounded to 0, so may be more around it: no way ahead is proven.
    if (v == 0.0) s = 0.0;
    // Beyond what the numbers hold.
    if (!(s <= zs_far)) {
        s = blind_step();
        zs_guess = true;
    }
    return f < 0.0 ? Answer(-s, -estimate, f, rate, false, false, object)
                   : Answer(s, estimate, f, rate, false, false, object);
}
