// The unit normal of the surface that a ray hits at p, on the side where it came from. Where f
// only touches 0, or may, it is taken a little before the surface, where the gradient does not vanish
// yet; where it vanishes or is undefined, a little before or behind, then farther off.
real3 surface_normal(Trace hit, real3 p, real3 d) {
    real footprint = pixel_footprint(hit.t);
    real least = min(0.01 * footprint, 30.0 * zs_relative_step * distance(frame.eye.xyz, p));
    real offset = hit.exact ? 0.0 : -least;
    for (int i = 0; i < min(6, int(frame.march.x) + 3); ++i) {
        real3 g = object_gradient(hit.object, p + offset * d, footprint);
        real most = max(abs(g.x), max(abs(g.y), abs(g.z)));
        if (most > 0.0 && !isinf(most) && !isnan(g.x + g.y + g.z)) {
            real3 n = normalize(g / most);
            if (hit.turned) n = -n;
            real away = dot(n, d);
            if (away <= 0.0) return n;
            // At a grazing hit rounding may turn it away a little: then it is across the ray.
            return away < 0.1 ? normalize(n - away * d) : -n;
        }
        offset = offset < 0.0 ? -offset : -max(4.0 * offset, least);
    }
    return -d;
}
