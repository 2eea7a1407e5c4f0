// Correct while the squares neither overflow nor vanish: between 1e-18 and 1e18.
real zs_hypot(real a, real b) { return sqrt(a * a + b * b); }
real zs_hypot3(real a, real b, real c) { return sqrt(a * a + b * b + c * c); }
