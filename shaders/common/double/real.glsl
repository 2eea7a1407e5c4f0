// The aliases in double precision. GLSL has few functions of doubles; those of shaders/operator/ that need
// others are in a folder double/ beside them.
#define real double
#define real2 dvec2
#define real3 dvec3
#define real4 dvec4

// Farther than anything: the distance of what is not there.
const real zs_far = 1e30;
// The smallest relative step that moves a point, with a margin.
const real zs_relative_step = 4e-16;
const real zs_half_pi = 1.5707963267948966lf;

real zs_nan() { return uintBitsToFloat(0x7fc00000u); }
