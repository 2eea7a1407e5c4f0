// Undefined for negative arguments in GLSL; here NaN.
real zs_sqrt(real x) { return x < 0.0 ? zs_nan() : sqrt(x); }
