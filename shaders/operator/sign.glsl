// GLSL's sign need not hand on NaN.
real zs_sign(real x) { return x < 0.0 ? -1.0 : (x > 0.0 ? 1.0 : x); }
