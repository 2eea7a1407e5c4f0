// A blend calculates with the values of its operands, which are distances as far as these are. How far
// along the ray what is known of them holds:
real zs_limit = zs_far;

// A value where it is defined; outside of the domain is outside.
real operand_value(real f) {
    if (!isnan(f)) return clamp(f, -zs_far, zs_far);
    ++zs_undefined;
    zs_guess = true;
    zs_limit = min(zs_limit, blind_step());
    return zs_far;
}

// An escape-time set: inside, nothing is known about how deep.
real escape_operand(real estimate, bool inside) {
    if (!inside) return isnan(estimate) ? 0.0 : clamp(estimate, 0.0, zs_far);
    zs_guess = true;
    zs_limit = min(zs_limit, 0.125 * blind_step());
    return -zs_far;
}

// The answer of a blend from its value, which changes by at most 1 / inverse times the way (0 where
// that is not known; then steps are blind). `reach` as for iterations.
Answer blend_answer(real f, real inverse, real reach, int object) {
    if (isnan(f)) return answer_undefined(object);
    bool known = inverse > 0.0;
    if (!known) zs_guess = true;
    real v = min(abs(f), zs_far);
    real s = min((known ? v * inverse : min(v, blind_step())) / frame.march.y, zs_limit);
    real estimate = min(reach * (known ? v * inverse : v), zs_far);
    return f < 0.0 ? Answer(-s, -estimate, f, 0.0, false, false, object)
                   : Answer(s, estimate, f, 0.0, false, false, object);
}
