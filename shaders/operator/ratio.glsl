// a / b where |a| <= b is known; 0 for 0 / 0.
real zs_ratio(real a, real b) { return b == 0.0 && a == 0.0 ? 0.0 : a / b; }
