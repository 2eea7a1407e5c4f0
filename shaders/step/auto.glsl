#include "step/certified.glsl"

// The certified step, and a guess only where there is none.
real formula_step(real v, real slope, real first, real3 bounds) {
    return certified_step(v, slope, first, bounds);
}
