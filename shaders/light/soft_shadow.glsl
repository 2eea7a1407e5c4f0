// How much of a light is seen from o: on the way to it, the smallest of k * distance / travelled
// (O 6.3.3, K 112). The nearest approach between two points is where the circles around them meet, of
// their distances (Aaltonen, "GPU-based clay simulation and ray-tracing tech in Claybook", GDC 2018, there
// for steps as long as the first distance), which takes the bands away.
// Heuristic: the distance is a first-order estimate.
real soft_shadow(real3 o, real3 l, real t0, real t1) {
    real k = frame.march.w;
    real seen = 1.0;
    real t = t0;
    real least = 2e-3 * length(frame.bounds_half.xyz);
    real before = 0.0, step = 0.0;
    bool rising = false;
    zs_aside = true;
    field_start(o, l, t0, t1);
    int steps = min(int(frame.march.x), 128);
    for (int i = 0; i < steps; ++i) {
        Answer a = field(o, l, t);
        field_accept();
        // A sheet's f that grew up to its change of sign and falls behind it has a pole there.
        bool falls = a.value * a.rate < 0.0;
        bool pole = a.sheet && rising && falls;
        if (a.free <= 0.0 && !pole) return 0.0;
        real h = min(a.distance, 1e6);
        // Where f is steep without being small the surface only seems to be near: f had its maximum there,
        // or falls, and the surface seems to be farther than before.
        bool steep = falls && (rising || (step > 0.0 && h > before));
        rising = a.value * a.rate > 0.0;
        real back = step > 0.0 ? (step * step + h * h - before * before) / (2.0 * step) : 0.0;
        back = clamp(back, 0.0, min(h, step));
        real nearest = sqrt(h * h - back * back);
        if (t > back && !rising && !steep) seen = min(seen, k * nearest / (t - back));
        if (seen < 0.01) return 0.0;
        before = h;
        step = max(min(a.free, max(h, least)), least);
        t += step;
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
