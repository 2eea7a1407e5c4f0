// The picture as it is usually written by hand around an estimate of the distance. Before this stand
//   const int max_steps, and in estimate() ++evaluations
//   float estimate(vec3 p)     how far to go
//   float surface(vec3 p)      what the normal is the gradient of
//   float near_enough(float t) below which estimate a ray ends
vec3 normal_by_central_differences(vec3 p, float h) {
    vec2 e = vec2(h, 0.0);
    vec3 g = vec3(surface(p + e.xyy) - surface(p - e.xyy), surface(p + e.yxy) - surface(p - e.yxy),
                  surface(p + e.yyx) - surface(p - e.yyx));
    return normalize(g);
}

// Quilez, "Soft shadows in raymarched SDFs": the smallest of k * distance / way.
float visibility(vec3 p, vec3 n, vec3 l, float footprint) {
    float size = length(frame.bounds_half.xyz);
    vec3 o = p + n * max(4.0 * footprint, 1e-4 * size);
    float t0, t1;
    if (!region_part(o, l, t0, t1)) return 1.0;
    float seen = 1.0;
    float t = t0 + 2e-3 * size;
    for (int i = 0; i < 128; ++i) {
        float h = estimate(o + t * l);
        seen = min(seen, frame.march.w * h / t);
        t += max(h, 2e-3 * size);
        if (seen < 0.01 || t > t1) break;
    }
    seen = clamp(seen, 0.0, 1.0);
    return seen * seen * (3.0 - 2.0 * seen);
}
