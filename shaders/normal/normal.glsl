// The unit normal of an object's surface at p, on the side where the ray came from. It is taken a little
// before the surface, where the gradient of a double root does not vanish yet; where it vanishes or is
// undefined, a little behind, then farther off.
real3 surface_normal(int object, bool turned, real3 p, real3 d, real footprint) {
    real offset = -min(0.01 * footprint, 30.0 * zs_relative_step * distance(frame.eye.xyz, p));
    for (int i = 0; i < min(6, int(frame.march.x) + 3); ++i) {
        real3 g = object_gradient(object, p + offset * d, footprint);
        real most = max(abs(g.x), max(abs(g.y), abs(g.z)));
        if (most > 0.0 && !isinf(most) && !isnan(g.x + g.y + g.z)) {
            real3 n = normalize(g / most);
            if (turned) n = -n;
            real away = dot(n, d);
            if (away <= 0.0) return n;
            // At a grazing hit rounding may turn it away a little: then it is across the ray.
            return away < 0.1 ? normalize(n - away * d) : -n;
        }
        offset = offset < 0.0 ? -offset : -4.0 * offset;
    }
    return -d;
}
