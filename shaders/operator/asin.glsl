// GLSL's own asin may be off by 4e-4. By the minimax polynomial of Cephes' asinf (Moshier), and
// asin(x) = pi/2 - 2 asin(sqrt((1 - x) / 2)) for large x. Outside of [-1, 1] NaN.
real zs_asin_small(real x) {
    real z = x * x;
    return x + x * z * ((((4.2163199048e-2 * z + 2.4181311049e-2) * z + 4.5470025998e-2) * z +
                         7.4953002686e-2) * z + 1.6666752422e-1);
}
real zs_asin(real x) {
    real a = abs(x);
    if (!(a <= 1.0)) return zs_nan();
    real y = a <= 0.5 ? zs_asin_small(a)
                      : 1.5707963267948966 - 2.0 * zs_asin_small(sqrt(0.5 - 0.5 * a));
    return x < 0.0 ? -y : y;
}
real zs_acos(real x) {
    real a = abs(x);
    if (!(a <= 1.0)) return zs_nan();
    if (a <= 0.5) return 1.5707963267948966 - zs_asin_small(x);
    real y = 2.0 * zs_asin_small(sqrt(0.5 - 0.5 * a));
    return x < 0.0 ? 3.1415926535897931 - y : y;
}
