// x = 2^n m with m near 1, and log m = 2 atanh(s) for s = (m - 1) / (m + 1), |s| < 0.172, by its series to
// the 21st power. Relative error of a few units in the last place; near 1 of s, so absolute there.
real zs_log(real x) {
    if (!(x > 0.0)) return zs_nan();
    if (isinf(x)) return x;
    bool small = x < 2.3e-308lf;
    uvec2 bits = unpackDouble2x32(small ? x * 18014398509481984.0lf : x);
    int n = int(bits.y >> 20) - (small ? 1077 : 1023);
    real m = packDouble2x32(uvec2(bits.x, (bits.y & 0xfffffu) | 0x3ff00000u));
    if (m > 1.4142135623730951lf) {
        m *= 0.5;
        ++n;
    }
    real s = (m - 1.0) / (m + 1.0);
    real z = s * s;
    real p = 1.0 / 21.0lf;
    p = p * z + 1.0 / 19.0lf;
    p = p * z + 1.0 / 17.0lf;
    p = p * z + 1.0 / 15.0lf;
    p = p * z + 1.0 / 13.0lf;
    p = p * z + 1.0 / 11.0lf;
    p = p * z + 1.0 / 9.0lf;
    p = p * z + 1.0 / 7.0lf;
    p = p * z + 1.0 / 5.0lf;
    p = p * z + 1.0 / 3.0lf;
    real series = 2.0 * s + 2.0 * s * z * p;
    return real(n) * 0.6931471803691238lf + (real(n) * 1.9082149292705877e-10lf + series);
}
