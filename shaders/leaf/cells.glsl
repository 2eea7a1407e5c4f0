// How far to a wall that the point is `u` away from, where u changes by `rate` along the ray: never 0,
// which would be a surface.
real cell_exit(real u, real rate) {
    real wall = rate < 0.0 ? max(max(u, 0.0) / -rate, 1e-30) : zs_far;
    zs_wall = min(zs_wall, wall);
    return wall;
}

// What is known of a cell holds up to its wall.
Answer answer_cell(Answer a, real wall) {
    a.free = clamp(a.free, -wall, wall);
    return a;
}
