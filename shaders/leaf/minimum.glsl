// The minimum of two values, and the part that the second one's gradient has in it.
real plain_minimum(real a, real b) { return b < a ? b : a; }
real plain_weight(real a, real b) { return b < a ? 1.0 : 0.0; }

// The polynomial smooth minimum (field::smooth_union). Its divisions are the same in each turn of a
// list's loop.
real smooth_minimum(real a, real b, real width) {
    real overlap = max(width - abs(a - b), 0.0);
    return min(a, b) - overlap * overlap * (0.25 / width);
}
real smooth_weight(real a, real b, real width) {
    real half_overlap = max(width - abs(a - b), 0.0) * (0.5 / width);
    return b < a ? 1.0 - half_overlap : half_overlap;
}
