#include "output/display.glsl"

// The picture: the lit surface, or what is behind.
vec3 pixel_colour(Trace hit, real3 o, real3 d, real3 n) {
    if (hit.status == zs_miss) return display(behind(o, d, zs_far));
    real3 p = o + hit.t * d;
    return display(shade(max(hit.object, 0), p, n, d, pixel_footprint(hit.t)));
}
