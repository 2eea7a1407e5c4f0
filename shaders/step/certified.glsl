// The certified step of a smooth formula: by Taylor along the ray |f|(t + s) >= v + v' s - M s^2 / 2
// with M a bound of the second derivative, and by the Lipschitz constant v - L s; the longer of the
// two. Where neither is good, half of the first-order distance (heuristic).
//   v = |f|, slope = d|f|/dt along the ray, first = |f| / |grad f|
//   bounds = 1 / L (0 if unbounded), M (negative if unbounded), whether the leaf is stiff
real certified_step(real v, real slope, real first, real3 bounds) {
    real s = v * bounds.x;
    if (bounds.y >= 0.0) {
        // Not 0, where nothing but that says how far a constant keeps its sign.
        real most = max(bounds.y, 1e-30), root = sqrt(slope * slope + 2.0 * most * v);
        // For a falling |f| the second form: the first would cancel.
        bool falls = slope < 0.0;
        real ahead = (falls ? 2.0 * v : slope + root) / (falls ? root - slope : most);
        s = max(s, min(ahead, zs_far));
    }
    if (bounds.z > 0.0) {
        real guess = min(0.5 * first, blind_step());
        // Where f has overflowed, s may be NaN.
        if (!(guess <= s)) {
            s = guess;
            zs_guess = true;
        }
    }
    return s;
}
