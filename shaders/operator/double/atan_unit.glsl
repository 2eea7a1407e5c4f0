// The angle is halved twice, tan(a / 2) = tan(a) / (1 + sqrt(1 + tan(a)^2)), which leaves |x| < 0.2, where
// the series to the 23rd power is as exact as the format. Relative error of a few units in the last place.
real zs_atan_unit(real x) {
    x /= 1.0 + sqrt(1.0 + x * x);
    x /= 1.0 + sqrt(1.0 + x * x);
    real z = x * x;
    real p = 1.0 / 23.0lf;
    p = 1.0 / 21.0lf - p * z;
    p = 1.0 / 19.0lf - p * z;
    p = 1.0 / 17.0lf - p * z;
    p = 1.0 / 15.0lf - p * z;
    p = 1.0 / 13.0lf - p * z;
    p = 1.0 / 11.0lf - p * z;
    p = 1.0 / 9.0lf - p * z;
    p = 1.0 / 7.0lf - p * z;
    p = 1.0 / 5.0lf - p * z;
    p = 1.0 / 3.0lf - p * z;
    return 4.0 * (x - x * z * p);
}
