// The unit normal of an object's surface at p, on the side where the ray came from. Where the gradient
// vanishes or is undefined, that a little nearer to the eye stands in.
real3 surface_normal(int object, bool turned, real3 p, real3 d, real footprint) {
    real back = 0.0;
    for (int i = 0; i < min(4, int(frame.march.x)); ++i) {
        real3 g = object_gradient(object, p - back * d, footprint);
        real most = max(abs(g.x), max(abs(g.y), abs(g.z)));
        if (most > 0.0 && !isinf(most)) {
            real3 n = normalize(g / most);
            if (turned) n = -n;
            real away = dot(n, d);
            if (away <= 0.0) return n;
            // At a grazing hit rounding may turn it away a little: then it is across the ray.
            return away < 0.1 ? normalize(n - away * d) : -n;
        }
        back = max(4.0 * back, footprint);
    }
    return -d;
}
