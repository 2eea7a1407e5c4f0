// The argument is taken to half of log 2 about 0 (Cody and Waite), where Taylor's series to the 13th power
// is as exact as the format. Relative error of a few units in the last place.

// 2^n for whole n; 0 or infinite beyond the exponents of the format.
real zs_power_of_two(int n) {
    int half_way = n / 2;
    uvec2 exponents = uvec2(clamp(ivec2(half_way, n - half_way) + 1023, 0, 2046));
    return packDouble2x32(uvec2(0u, exponents.x << 20)) * packDouble2x32(uvec2(0u, exponents.y << 20));
}
real zs_exp(real x) {
    if (isnan(x)) return x;
    real n = floor(clamp(x, -800.0, 800.0) * 1.4426950408889634lf + 0.5);
    // The first part has 32 bits, so that its product with n is exact; precise, so that no driver reorders.
    precise real r = (clamp(x, -800.0, 800.0) - n * 0.6931471803691238lf) - n * 1.9082149292705877e-10lf;
    real p = 1.0 / 6227020800.0lf;
    p = p * r + 1.0 / 479001600.0lf;
    p = p * r + 1.0 / 39916800.0lf;
    p = p * r + 1.0 / 3628800.0lf;
    p = p * r + 1.0 / 362880.0lf;
    p = p * r + 1.0 / 40320.0lf;
    p = p * r + 1.0 / 5040.0lf;
    p = p * r + 1.0 / 720.0lf;
    p = p * r + 1.0 / 120.0lf;
    p = p * r + 1.0 / 24.0lf;
    p = p * r + 1.0 / 6.0lf;
    p = p * r + 0.5;
    return (1.0 + (r + r * r * p)) * zs_power_of_two(int(n));
}
