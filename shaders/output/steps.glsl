#include "output/as_it_is.glsl"

// The number of steps as a colour: dark blue for few, through green and yellow to red for all that
// are allowed, on a logarithmic scale; magenta where they were not enough.
vec3 pixel_light(Trace hit, real3 o, real3 d, real3 n) {
    if (hit.status == zs_unresolved) return vec3(1.0, 0.0, 1.0);
    float part = log2(1.0 + float(hit.steps)) / log2(1.0 + float(frame.march.x));
    vec3 c = clamp(vec3(3.0 * part - 1.2, 2.0 * part, 0.35 + part), 0.0, 1.0);
    return part > 0.5 ? mix(c, vec3(1.0, 2.0 - 2.0 * part, 0.0), clamp(4.0 * part - 2.0, 0.0, 1.0)) : c;
}
