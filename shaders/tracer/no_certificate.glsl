#include "tracer/trace.glsl"

// Nobody asks what is proven.
void certify_start() {}
void certify_step(real t, real way, real free, real least, real rest) {}
void certify_end() {}
void certify_sides() {}
void certify_passing() {}
void certify_trace(Trace trace, real3 o, real3 d, real t1) {}
void recall_certificate(real told) {}
