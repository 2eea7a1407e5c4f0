// Powers of what is greater than 0; GLSL's own is undefined elsewhere.
real zs_positive_pow(real a, real b) { return pow(a, b); }
