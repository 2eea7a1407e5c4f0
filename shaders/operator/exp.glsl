real zs_exp(real x) { return exp(x); }
