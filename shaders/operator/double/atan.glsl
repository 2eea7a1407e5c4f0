// The angle is halved twice, tan(a / 2) = tan(a) / (1 + sqrt(1 + tan(a)^2)), which leaves |x| < 0.2, where
// the series to the 23rd power is as exact as the format. Relative error of a few units in the last place.
// The branch cut of atan2 is the negative x axis, where the angle is pi whatever the sign of a zero y.
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
real zs_atan(real x) {
    real a = abs(x);
    real y = a > 1.0 ? 1.5707963267948966lf - zs_atan_unit(1.0 / a) : zs_atan_unit(a);
    return x < 0.0 ? -y : y;
}
real zs_atan2(real y, real x) {
    if (isnan(x) || isnan(y)) return zs_nan();
    real a = abs(x), b = abs(y);
    real most = max(a, b);
    real part = most == 0.0 ? 0.0 : (isinf(most) ? (a == b ? 1.0 : 0.0) : min(a, b) / most);
    real angle = zs_atan_unit(part);
    if (b > a) angle = 1.5707963267948966lf - angle;
    if (x < 0.0) angle = 3.141592653589793lf - angle;
    return y < 0.0 ? -angle : angle;
}
