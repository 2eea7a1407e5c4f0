// The answer of a formula from its value and gradient. The sign is that of f; outside of its domain
// is outside.
Answer formula_answer(real f, real3 g, real3 d, real3 bounds, int object) {
    if (zs_has_edges && isnan(f)) return answer_undefined(object);
    real v = abs(f);
    real rate = dot(g, d);
    // By the gradient over f, whose square neither overflows nor vanishes where that of a large or small
    // gradient does. Where f is flat, or so large that the gradient may have overflowed, nothing says
    // how far the surface is.
    real estimate = v < zs_far ? min(1.0 / length(g * (1.0 / v)), zs_far) : zs_far;
    if (v == 0.0) estimate = 0.0;
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
