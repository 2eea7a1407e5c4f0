// As in single precision: the argument is taken to [-pi/4, pi/4] in three parts (Cody and Waite), where
// Taylor's series to the 17th and 16th power are as exact as the format. Absolute error of a few units in
// the last place of 1 for arguments up to 100,000.
real2 zs_sincos(real x) {
    if (isinf(x) || isnan(x)) return real2(zs_nan());
    real n = floor(x * 0.6366197723675814lf + 0.5);
    // The first two have 33 bits each, so that their products with n are exact.
    real a = ((x - n * 1.5707963267341256lf) - n * 6.077100506303966e-11lf) - n * 2.0222662487959506e-21lf;
    if (abs(a) > 1.0) a = 0.0;  // no digit is left
    real z = a * a;
    real s = 1.0 / 355687428096000.0lf;
    s = s * z - 1.0 / 1307674368000.0lf;
    s = s * z + 1.0 / 6227020800.0lf;
    s = s * z - 1.0 / 39916800.0lf;
    s = s * z + 1.0 / 362880.0lf;
    s = s * z - 1.0 / 5040.0lf;
    s = s * z + 1.0 / 120.0lf;
    s = s * z - 1.0 / 6.0lf;
    s = a + a * z * s;
    real c = 1.0 / 20922789888000.0lf;
    c = c * z - 1.0 / 87178291200.0lf;
    c = c * z + 1.0 / 479001600.0lf;
    c = c * z - 1.0 / 3628800.0lf;
    c = c * z + 1.0 / 40320.0lf;
    c = c * z - 1.0 / 720.0lf;
    c = c * z + 1.0 / 24.0lf;
    c = (1.0 - 0.5 * z) + z * z * c;
    real quarter = n - 4.0 * floor(n * 0.25);
    bool odd = quarter == 1.0 || quarter == 3.0;
    real sine = odd ? c : s;
    real cosine = odd ? s : c;
    return real2(quarter >= 2.0 ? -sine : sine, quarter == 1.0 || quarter == 2.0 ? -cosine : cosine);
}
real zs_sin(real x) { return zs_sincos(x).x; }
real zs_cos(real x) { return zs_sincos(x).y; }
