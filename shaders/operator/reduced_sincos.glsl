// Sine and cosine of what x is beyond n quarters of a turn, and n: the argument is taken to [-pi/4, pi/4] in
// three parts (Cody and Waite), where both are polynomials (Cephes' sinf and cosf, Moshier). Absolute error of
// a few units in the last place of 1 for arguments up to 100,000, growing fast beyond.
real zs_reduced_sincos(real x, out real s, out real c) {
    real n = floor(x * 0.63661977236758134 + 0.5);
    // The first two have 8 bits each, so that their products with n are exact.
    real a = ((x - n * 1.5703125) - n * 4.825592041015625e-4) - n * 1.2675907950567e-6;
    if (abs(a) > 1.0) a = 0.0;  // no digit is left
    real z = a * a;
    s = a + a * z * ((-1.9515295891e-4 * z + 8.3321608736e-3) * z - 1.6666654611e-1);
    c = 1.0 - 0.5 * z + z * z * ((2.443315711809948e-5 * z - 1.388731625493765e-3) * z +
                                      4.166664568298827e-2);
    return n;
}
