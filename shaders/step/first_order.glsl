// The first-order distance |f| / |grad f| (Taubin 1994); heuristic: it may pass a surface.
real formula_step(real v, real slope, real first, real3 bounds) {
    zs_guess = true;
    return min(first, blind_step());
}
