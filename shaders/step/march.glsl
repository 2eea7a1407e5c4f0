#include "step/certified.glsl"

// Fixed steps ask for nothing but the sign; shadows go by certified steps.
bool zs_sign_only = false;

real formula_step(real v, real slope, real first, real3 bounds) {
    if (zs_sign_only) return v > 0.0 ? 1.0 : 0.0;
    return certified_step(v, slope, first, bounds);
}
