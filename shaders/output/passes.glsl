#include "output/surface.glsl"

// One pixel by three passes, geometry, light and image, of which the first ones may be left out: what
// they would find is what an earlier frame has kept, at the same place of the picture.
layout(binding = 2) uniform sampler2D kept_geometry;
layout(binding = 3) uniform sampler2D kept_normal;
layout(binding = 4) uniform sampler2D kept_light;

const int zs_geometry_pass = 0, zs_light_pass = 1;

void main() {
    // What is kept may be finer than what is drawn.
    real2 pixel = floor((floor(gl_FragCoord.xy) + 0.5) * frame.passes.yz);
    real3 o = frame.eye.xyz;
    real3 d = picture_direction(pixel + frame.picture.zw + 0.5);
    int first = int(frame.passes.x);
    Trace hit;
    real3 n;
    if (first == zs_geometry_pass) {
        hit = visible_surface(o, d, n);
    } else {
        vec4 kept = texelFetch(kept_geometry, ivec2(pixel), 0);
        hit = Trace(int(kept.z), kept.x, int(kept.w), false, false, false, int(kept.y));
        vec4 told = texelFetch(kept_normal, ivec2(pixel), 0);
        n = told.xyz;
        recall_certificate(told.w);
    }
    vec3 light;
    if (first <= zs_light_pass) {
        light = pixel_light(hit, o, d, n);
    } else {
        light = texelFetch(kept_light, ivec2(pixel), 0).rgb;
    }
    write_pixel(hit, n, light);
}
