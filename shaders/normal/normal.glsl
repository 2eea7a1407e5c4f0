// The unit normal of an object's surface at p, facing the eye. Where the gradient vanishes or is
// undefined, that a little nearer to the eye stands in.
real3 surface_normal(int object, real3 p, real3 d, real footprint) {
    real back = 0.0;
    for (int i = 0; i < min(4, int(frame.march.x)); ++i) {
        real3 g = object_gradient(object, p - back * d, footprint);
        real most = max(abs(g.x), max(abs(g.y), abs(g.z)));
        if (most > 0.0 && !isinf(most)) {
            real3 n = normalize(g / most);
            return dot(n, d) > 0.0 ? -n : n;
        }
        back = max(4.0 * back, footprint);
    }
    return -d;
}
