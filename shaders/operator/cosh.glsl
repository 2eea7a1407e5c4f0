#include "operator/exp.glsl"

// In two halves, so that it overflows no earlier than it must.
real zs_cosh(real x) {
    real e = zs_exp(0.5 * abs(x));
    return 0.5 * e * e + 0.5 / e / e;
}
