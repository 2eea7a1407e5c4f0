#include "output/display.glsl"
#include "tracer/trace.glsl"

// The light where no ray can meet the bounds of the scene.
vec3 pixel_light(Trace hit, real3 o, real3 d, real3 n) { return vec3(behind(o, d, zs_far)); }

Trace nothing() { return Trace(zs_miss, 0.0, -1, false, false, false, 0); }

real3 behind_direction() {
    real2 pixel = floor((floor(gl_FragCoord.xy) + 0.5) * frame.passes.yz);
    return picture_direction(pixel + frame.picture.zw + 0.5);
}
