#include "tracer/trace.glsl"

// No ray is followed: how far each goes is told from outside, and the field is asked there once. What
// is left is the least that any tracer has to do. For measuring.

// A pixel each, the first row at the top; +infinity for a miss.
layout(binding = 0) uniform sampler2D told_depth;

Trace trace(real3 o, real3 d, real t0, real t1) {
    real t = texelFetch(told_depth, ivec2(gl_FragCoord.xy), 0).r;
    if (isinf(t)) return Trace(zs_miss, t1, -1, false, false, false, 0);
    field_start(o, d, t, t);
    Answer a = field(o, d, t);
    bool cap = t <= t0 + 4.0 * zs_relative_step * t0;
    return Trace(zs_hit, t, max(a.object, 0), a.turned, cap, false, 1);
}
