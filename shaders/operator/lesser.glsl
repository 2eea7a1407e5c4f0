// min and max of what is never NaN: one instruction, which GLSL's own, with their care for NaN, are not
// everywhere.
real zs_lesser(real a, real b) { return a < b ? a : b; }
real zs_greater(real a, real b) { return a > b ? a : b; }
