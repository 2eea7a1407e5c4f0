#include "operator/sin.glsl"

real zs_tan(real x) { return zs_sin(x) / zs_cos(x); }
