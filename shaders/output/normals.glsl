#include "output/as_it_is.glsl"

// The normal as a colour; what is behind is black.
vec3 pixel_light(Trace hit, real3 o, real3 d, real3 n) {
    return hit.status == zs_miss ? vec3(0.0) : vec3(0.5 + 0.5 * n);
}
