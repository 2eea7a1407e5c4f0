// The choice between two numbers by two that are never NaN.
real zs_choose(real a, real b, real c, real d) { return a < b ? c : d; }
