// The Menger sponge: a box less a cross of bars in each cell of each level. Before this stands
//   const int levels
const int max_steps = 256;
int evaluations = 0;

float estimate(vec3 p) {
    ++evaluations;
    vec3 q = abs(p) - 1.0;
    float d = length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);
    float scale = 1.0;
    for (int i = 0; i < levels; ++i) {
        vec3 r = abs(1.0 - 3.0 * abs(mod(scale * p, 2.0) - 1.0));
        scale *= 3.0;
        float cross_of_bars = min(max(r.x, r.y), min(max(r.y, r.z), max(r.z, r.x)));
        d = max(d, (cross_of_bars - 1.0) / scale);
    }
    return d;
}

float surface(vec3 p) { return estimate(p); }

float near_enough(float t) { return frame.march.z * pixel_footprint(t); }
