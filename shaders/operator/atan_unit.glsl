// The angle whose tangent is x, from 0 to 1: by the minimax polynomial of Cephes' atanf (Moshier) on [0, tan(pi/8)].
real zs_atan_unit(real x) {
    bool large = x > 0.4142135623730951;
    real y = large ? (x - 1.0) / (x + 1.0) : x;
    real z = y * y;
    real p = y + y * z * (((8.05374449538e-2 * z - 1.38776856032e-1) * z + 1.99777106478e-1) * z -
                          3.33329491539e-1);
    return large ? p + 0.78539816339744831 : p;
}
