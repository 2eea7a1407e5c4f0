// The first-order distance |f| / |grad f| (Taubin 1994) taken for a distance: unsafe. The gradient is
// that of the formula, not by differences. Before this stands
//   const bool is_sheet
const int max_steps = 4096;
int evaluations = 0;

// FORMULA

float estimate(vec3 p) {
    ++evaluations;
    vec3 g;
    float v = f_and_gradient(p, g);
    return (is_sheet ? abs(v) : v) / max(length(g), 1e-30);
}

float surface(vec3 p) { return f(p); }

float near_enough(float t) { return frame.march.z * pixel_footprint(t); }
