#include "tracer/stride.glsl"

// Over-relaxed sphere tracing (Keinert, Schaefer, Korndoerfer, Ganse, Stamminger, "Enhanced Sphere
// Tracing", STAG 2014): strides of 1.6 radii, and back to where the last sphere ends if the next one does
// not reach it. As safe as the radii are. After a step back the ray goes on without relaxation: it is
// near a surface.
real zs_radius = 0.0;
real zs_relaxation = 1.0;
bool zs_is_relaxed = false;

void stride_start() {
    zs_relaxation = 1.6;
    zs_is_relaxed = false;
}

Answer stride_answer(real3 o, real3 d, real t) { return field(o, d, t); }

// Whether the stride that led here may have passed a surface.
bool stride_has_parted(Answer a, real way) {
    if (!zs_is_relaxed || (a.free > 0.0 && a.free >= way - zs_radius)) return false;
    zs_relaxation = 1.0;
    zs_is_relaxed = false;
    return true;
}

real stride_back() { return zs_radius; }

real stride(real free, real epsilon) {
    zs_radius = free;
    // Not after a guess, nor where the stride is the least one and its sphere no proof, nor out of a cell,
    // beyond whose wall the spheres say nothing.
    real most = zs_guess || free <= epsilon ? free : max(free, 0.99 * zs_wall);
    real way = min(zs_relaxation * free, most);
    zs_is_relaxed = way > free;
    return way;
}
bool stride_is_checked() { return zs_is_relaxed; }
