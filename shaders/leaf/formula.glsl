// The answer of a formula from its value and gradient. The sign is that of f; outside of its domain
// is outside.
Answer formula_answer(real f, real3 g, real3 d, real3 bounds, int object) {
    if (isnan(f)) return answer_undefined(object);
    real v = abs(f);
    real norm = length(g);
    real rate = dot(g, d);
    // Where f is flat and not 0, nothing says how far the surface is.
    real estimate = v > 0.0 ? (norm > 0.0 ? min(v / norm, zs_far) : zs_far) : 0.0;
    real s = formula_step(v, f < 0.0 ? -rate : rate, estimate, bounds) / frame.march.y;
    return f < 0.0 ? Answer(-s, -estimate, f, rate, false, false, object)
                   : Answer(s, estimate, f, rate, false, false, object);
}
