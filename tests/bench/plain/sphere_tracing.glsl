// Sphere tracing of a formula: its value over the Lipschitz constant of the region. Before this stand
//   const bool is_sheet; float inverse_lipschitz (a macro)
const int max_steps = 4096;
int evaluations = 0;

// FORMULA

float estimate(vec3 p) {
    ++evaluations;
    float v = f(p);
    return (is_sheet ? abs(v) : v) * inverse_lipschitz;
}

float surface(vec3 p) { return f(p); }

// Where the region's constant is far above the slope, the estimate is far below the distance: a part of a
// pixel would end rays many pixels before the surface.
float near_enough(float t) { return 1e-6 * t; }
