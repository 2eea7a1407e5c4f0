#include "operator/exp.glsl"
#include "operator/log.glsl"

// Powers of what is greater than 0. Relative error of a few units in the last place times 1 + |b log a|.
real zs_positive_pow(real a, real b) {
    if (isinf(a)) return b > 0.0 ? a : 0.0;
    return zs_exp(b * zs_log(a));
}
