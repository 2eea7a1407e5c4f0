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
// that is not known; then steps are blind), and here about by `slope` times it. `reach` as for
// iterations.
Answer blend_answer(real f, real slope, real inverse, real reach, int object) {
    if (isnan(f)) return answer_undefined(object);
    real v = min(abs(f), zs_far);
    if (!(inverse > 0.0)) zs_guess = true;
    real s = min((inverse > 0.0 ? v * inverse : min(v, blind_step())) * frame.up.w, zs_limit);
    real estimate = v > 0.0 ? (slope > 0.0 ? min(reach * v / slope, zs_far) : zs_far) : 0.0;
    return f < 0.0 ? Answer(-s, -estimate, f, 0.0, false, false, object)
                   : Answer(s, estimate, f, 0.0, false, false, object);
}
