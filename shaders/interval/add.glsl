#include "interval/interval.glsl"

real2 interval_add(real2 a, real2 b) { return interval_outward(a + b); }
