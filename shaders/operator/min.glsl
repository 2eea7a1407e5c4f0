// GLSL's min and max may drop a NaN; here it goes through.
real zs_min(real a, real b) { return a < b ? a : (b <= a ? b : a + b); }
real zs_max(real a, real b) { return a > b ? a : (b >= a ? b : a + b); }
