// Undefined for negative arguments in GLSL; here NaN, and -infinity for zero.
real zs_log(real x) { return x < 0.0 ? zs_nan() : log(x); }
