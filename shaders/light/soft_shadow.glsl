// How much of a light is seen from p: on the way to it, the smallest of k * distance / travelled
// (O 6.3.3, K 112), smoothed at both ends. Heuristic: the distance is a first-order estimate.
real soft_shadow(real3 o, real3 l, real t0, real t1) {
    real k = frame.march.w;
    real seen = 1.0;
    real t = t0;
    real least = 2e-3 * length(frame.bounds_half.xyz);
    field_start();
    bool rising = false;
    int steps = min(int(frame.march.x), 128);
    for (int i = 0; i < steps; ++i) {
        Answer a = field(o + t * l, l);
        field_accept();
        // A sheet's f that grew up to its change of sign and falls behind it has a pole there.
        bool pole = a.sheet && rising && a.value * a.rate < 0.0;
        if (a.free <= 0.0 && !pole) return 0.0;
        rising = a.value * a.rate > 0.0;
        if (t > 0.0 && !rising && !pole) seen = min(seen, k * a.distance / t);
        if (seen < 0.01) return 0.0;
        t += max(min(a.free, max(a.distance, least)), least);
        if (t > t1) break;
    }
    return seen * seen * (3.0 - 2.0 * seen);
}

real visibility(real3 p, real3 n, real3 l, real footprint) {
    real t0, t1;
    // Off the surface by some pixels, so that it does not darken itself.
    real3 o = p + n * max(4.0 * footprint, 1e-4 * length(frame.bounds_half.xyz));
    if (!region_part(o, l, t0, t1)) return 1.0;
    return soft_shadow(o, l, t0, t1);
}
