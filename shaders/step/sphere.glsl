// Sphere tracing (Hart 1996): |f| over the Lipschitz constant of the region; certified. Where that
// is unbounded, half of the first-order distance (heuristic).
real formula_step(real v, real slope, real first, real3 bounds) {
    if (bounds.x > 0.0) return v * bounds.x;
    zs_guess = true;
    return min(0.5 * first, blind_step());
}
