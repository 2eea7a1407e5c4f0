// a / b where |a| <= b is known, so that the quotient is kept in [-1, 1]; 0 for 0 / 0. Not by clamp or
// by two comparisons, which drivers turn into one: those lose NaN.
real zs_ratio(real a, real b) {
    real q = b == 0.0 && a == 0.0 ? 0.0 : a / b;
    return abs(q) > 1.0 ? sign(q) : q;
}
