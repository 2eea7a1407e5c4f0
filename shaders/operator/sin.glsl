#include "operator/reduced_sincos.glsl"

// Sine and cosine together, because what needs one mostly needs both, and half of the work is the
// same. The quarter of the turn says which is which.
real2 zs_sincos(real x) {
    if (isinf(x)) return real2(zs_nan());
    real s, c;
    real n = zs_reduced_sincos(x, s, c);
    real quarter = n - 4.0 * floor(n * 0.25);
    bool odd = quarter == 1.0 || quarter == 3.0;
    real sine = odd ? c : s;
    real cosine = odd ? s : c;
    return real2(quarter >= 2.0 ? -sine : sine, quarter == 1.0 || quarter == 2.0 ? -cosine : cosine);
}
real zs_sin(real x) { return zs_sincos(x).x; }
real zs_cos(real x) { return zs_sincos(x).y; }
