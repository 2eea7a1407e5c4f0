// Undefined for negative arguments in GLSL; here NaN, for zero as well.
real zs_log(real x) { return x > 0.0 ? log(x) : zs_nan(); }
