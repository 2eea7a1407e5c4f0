#include "output/display.glsl"

// The light that comes from the surface, or from what is behind.
vec3 pixel_light(Trace hit, real3 o, real3 d, real3 n) {
    if (hit.status == zs_miss) return vec3(behind(o, d, zs_far));
    real3 p = o + hit.t * d;
    return vec3(shade(max(hit.object, 0), p, n, d, pixel_footprint(hit.t)));
}
