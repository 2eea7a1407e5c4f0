// Sine and cosine with the argument taken to [-pi, pi] in three parts (Cody and Waite): absolute
// error of a few units in the last place of 1 for arguments up to 50,000, growing fast beyond.
real zs_turn(real x) {
    real n = floor(x * 0.15915494309189535 + 0.5);
    return ((x - n * 6.28125) - n * 1.9350051879882812e-3) - n * 3.0199157663e-7;
}
real zs_sin(real x) { return isinf(x) ? zs_nan() : sin(zs_turn(x)); }
real zs_cos(real x) { return isinf(x) ? zs_nan() : cos(zs_turn(x)); }
