// The Frobenius norm of a Hessian from its diagonal and what is above that: at least the spectral norm.
real hessian_norm(real3 diagonal, real3 above) {
    return sqrt(dot(diagonal, diagonal) + 2.0 * dot(above, above));
}

// The second-order distance sqrt(|g|^2 / m^2 + 2 |f| / m) - |g| / m (K 106) with g the gradient and m
// the norm of the Hessian, both at the point: m is bounds.y. Heuristic: m may be larger farther on.
real formula_step(real v, real slope, real first, real3 bounds) {
    zs_guess = true;
    // At a kink m is undefined: then it counts as 0.
    real m = bounds.y > 0.0 ? bounds.y : 0.0;
    real norm = v > 0.0 ? v / first : 0.0;
    // As a quotient: the difference would cancel.
    real step = v > 0.0 ? 2.0 * v / (norm + sqrt(norm * norm + 2.0 * m * v)) : 0.0;
    return min(step, blind_step());
}
