// The gradient of a leaf by four differences on a tetrahedron of the size h.
real3 object_differences(int object, real3 p, real h) {
    real3 g = real3(0.0);
    // A bound that compilers cannot see keeps the leaf's code in one place.
    for (int i = 0; i < min(4, int(frame.march.x) + 3); ++i) {
        real3 e = 2.0 * real3(((i + 3) >> 1) & 1, (i >> 1) & 1, i & 1) - 1.0;
        g += e * object_distance(object, p + h * e);
    }
    return g;
}
