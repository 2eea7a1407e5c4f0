// Sine and cosine together, because what needs one mostly needs both, and half of the work is the
// same: the argument is taken to [-pi/4, pi/4] in three parts (Cody and Waite), where both are
// polynomials (Cephes' sinf and cosf, Moshier), and the quarter of the turn says which is which.
// Absolute error of a few units in the last place of 1 for arguments up to 100,000, growing
// fast beyond.
real2 zs_sincos(real x) {
    if (isinf(x)) return real2(zs_nan());
    real n = floor(x * 0.63661977236758134 + 0.5);
    // The first two have 8 bits each, so that their products with n are exact.
    real a = ((x - n * 1.5703125) - n * 4.825592041015625e-4) - n * 1.2675907950567e-6;
    if (abs(a) > 1.0) a = 0.0;  // no digit is left
    real z = a * a;
    real s = a + a * z * ((-1.9515295891e-4 * z + 8.3321608736e-3) * z - 1.6666654611e-1);
    real c = 1.0 - 0.5 * z + z * z * ((2.443315711809948e-5 * z - 1.388731625493765e-3) * z +
                                      4.166664568298827e-2);
    real quarter = n - 4.0 * floor(n * 0.25);
    bool odd = quarter == 1.0 || quarter == 3.0;
    real sine = odd ? c : s;
    real cosine = odd ? s : c;
    return real2(quarter >= 2.0 ? -sine : sine, quarter == 1.0 || quarter == 2.0 ? -cosine : cosine);
}
real zs_sin(real x) { return zs_sincos(x).x; }
real zs_cos(real x) { return zs_sincos(x).y; }
