// By the minimax polynomial of Cephes' atanf (Moshier) on [0, tan(pi/8)]. The branch cut of atan2 is
// the negative x axis, where the angle is pi whatever the sign of a zero y.
real zs_atan_unit(real x) {
    bool large = x > 0.4142135623730951;
    real y = large ? (x - 1.0) / (x + 1.0) : x;
    real z = y * y;
    real p = y + y * z * (((8.05374449538e-2 * z - 1.38776856032e-1) * z + 1.99777106478e-1) * z -
                          3.33329491539e-1);
    return large ? p + 0.78539816339744831 : p;
}
real zs_atan(real x) {
    real a = abs(x);
    real y = a > 1.0 ? 1.5707963267948966 - zs_atan_unit(1.0 / a) : zs_atan_unit(a);
    return x < 0.0 ? -y : y;
}
real zs_atan2(real y, real x) {
    if (isnan(x) || isnan(y)) return zs_nan();
    real a = abs(x), b = abs(y);
    real most = max(a, b);
    real part = most == 0.0 ? 0.0 : (isinf(most) ? (a == b ? 1.0 : 0.0) : min(a, b) / most);
    real angle = zs_atan_unit(part);
    if (b > a) angle = 1.5707963267948966 - angle;
    if (x < 0.0) angle = 3.1415926535897931 - angle;
    return y < 0.0 ? -angle : angle;
}
