#include "operator/exp.glsl"

// GLSL's own sinh and tanh may lose all digits near 0. There series; tanh by the minimax polynomial
// of Cephes' tanhf (Moshier).
real zs_sinh(real x) {
    real z = x * x;
    if (z < 1.0) {
        return x + x * z * (((2.7557319224e-6 * z + 1.9841269841e-4) * z + 8.3333333333e-3) * z +
                            1.6666666667e-1);
    }
    // In two halves, so that it overflows no earlier than it must.
    real e = zs_exp(0.5 * abs(x));
    real y = 0.5 * e * e - 0.5 / e / e;
    return x < 0.0 ? -y : y;
}
real zs_tanh(real x) {
    real a = abs(x);
    if (a < 0.625) {
        real z = x * x;
        return x + x * z * ((((-5.70498872745e-3 * z + 2.06390887954e-2) * z - 5.37397155531e-2) * z +
                             1.33314422036e-1) * z - 3.33332819422e-1);
    }
    real y = 1.0 - 2.0 / (zs_exp(2.0 * a) + 1.0);
    return x < 0.0 ? -y : y;
}
