// All computation is written over these aliases, so that a program can change its precision.
#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4

// Farther than anything: the distance of what is not there.
const real zs_far = 1e30;
// The smallest relative step that moves a point, with a margin.
const real zs_relative_step = 2e-7;
const real zs_half_pi = 1.5707963267948966;

real zs_nan() { return uintBitsToFloat(0x7fc00000u); }
