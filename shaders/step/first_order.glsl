// The first-order distance |f| / |grad f| (Taubin 1994); heuristic: it may pass a surface.
real formula_step(real v, real slope, real norm, real3 bounds) {
    zs_guess = true;
    return min(v / norm, blind_step());
}
