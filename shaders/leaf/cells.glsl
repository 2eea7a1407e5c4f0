// How far to a wall that the point is `u` away from, where u changes by `rate` along the ray.
real cell_exit(real u, real rate) { return rate < 0.0 ? max(u, 0.0) / -rate : zs_far; }

// What is known of a cell holds up to its wall.
Answer answer_cell(Answer a, real wall) {
    real end = max(wall, 1e-30);
    a.free = clamp(a.free, -end, end);
    return a;
}
