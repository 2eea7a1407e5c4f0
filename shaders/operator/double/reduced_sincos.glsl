// As in single precision, by Taylor's series to the 17th and 16th power, which are as exact as the format.
real zs_reduced_sincos(real x, out real s, out real c) {
    real n = floor(x * 0.6366197723675814lf + 0.5);
    // The first two have 33 bits each, so that their products with n are exact; precise, so that no driver reorders.
    precise real a = ((x - n * 1.5707963267341256lf) - n * 6.077100506303966e-11lf) - n * 2.0222662487959506e-21lf;
    if (abs(a) > 1.0) a = 0.0;  // no digit is left
    real z = a * a;
    s = 1.0 / 355687428096000.0lf;
    s = s * z - 1.0 / 1307674368000.0lf;
    s = s * z + 1.0 / 6227020800.0lf;
    s = s * z - 1.0 / 39916800.0lf;
    s = s * z + 1.0 / 362880.0lf;
    s = s * z - 1.0 / 5040.0lf;
    s = s * z + 1.0 / 120.0lf;
    s = s * z - 1.0 / 6.0lf;
    s = a + a * z * s;
    c = 1.0 / 20922789888000.0lf;
    c = c * z - 1.0 / 87178291200.0lf;
    c = c * z + 1.0 / 479001600.0lf;
    c = c * z - 1.0 / 3628800.0lf;
    c = c * z + 1.0 / 40320.0lf;
    c = c * z - 1.0 / 720.0lf;
    c = c * z + 1.0 / 24.0lf;
    c = (1.0 - 0.5 * z) + z * z * c;
    return n;
}
