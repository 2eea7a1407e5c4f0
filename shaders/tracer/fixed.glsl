#include "tracer/stride.glsl"

// Strides of one length, whatever the field says but on which side a point is (O 6.2.1, K algorithm 2):
// the diagonal of the bounds over 7/8 of the steps. The rest is for what lies behind poles and, without
// bounds, outside of the region that is framed, where strides grow.
void stride_start() {}
bool stride_has_parted(Answer a, real way) { return false; }
real stride_back() { return 0.0; }

Answer stride_answer(real3 o, real3 d, real t) {
    zs_sign_only = true;
    Answer a = field(o, d, t);
    zs_sign_only = false;
    zs_guess = true;
    // Nothing counts as near.
    if (a.free > 0.0) a.free = zs_far;
    return a;
}

real stride(real free, real epsilon) {
    real diagonal = 2.0 * length(frame.bounds_half.xyz);
    real away = distance(zs_point, frame.bounds_centre.xyz);
    real fixed_stride = max(diagonal / (0.875 * frame.march.x), epsilon);
    return 2.0 * away > diagonal ? max(fixed_stride, away / 16.0) : fixed_stride;
}
bool stride_is_checked() { return false; }
