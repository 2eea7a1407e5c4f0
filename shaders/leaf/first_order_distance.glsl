// |f| over its gradient: the distance to the first order. By the gradient over f, whose square neither overflows
// nor vanishes where that of a large or small gradient does. Where f is flat, or so large that the gradient
// may have overflowed, nothing says how far the surface is.
real first_order_distance(real v, real3 g) {
    if (v == 0.0) return 0.0;
    return v < zs_far ? min(1.0 / length(g * (1.0 / v)), zs_far) : zs_far;
}
