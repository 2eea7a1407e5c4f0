#include "tracer/stride.glsl"
#include "tracer/trace.glsl"

// What a ray proves on its way: as long as every step is as short as the field proves it, nothing is
// passed. True of real numbers: the rounding of f in single precision comes on top, except where it is
// taken off the values.
bool zs_asked = false;         // whether the ray meets the bounds at all
bool zs_doubt = false;         // whether something was guessed
bool zs_least = false;         // whether that was at most the least step
real zs_proven_until = zs_far;  // where the first step began that was the least, not a shorter proven one
bool zs_enclosed = false;      // whether the surface is between two points on its two sides

// The field is about to be asked.
void certify_start() { zs_asked = true; }

// A step from t by `way` where the field allows `free`, `rest` before the end; none is shorter than `least`.
void certify_step(real t, real way, real free, real least, real rest) {
    // A scale below 1 makes `free` longer than what is proven.
    real proven = zs_guess ? 0.0 : free * min(frame.march.y, 1.0);
    if (way <= proven || proven >= rest) return;
    zs_proven_until = min(zs_proven_until, t);
    if (zs_guess) zs_least = true;
    if (way > least) zs_doubt = true;
}

// The march has ended; what is settled may become a surface.
void certify_end() { zs_enclosed = false; }

// That is one between two points where the field has different sides.
void certify_sides() { zs_enclosed = true; }

// What looked like a surface is taken for a pole, a jump or the edge of a domain, or lies behind the end.
void certify_passing() { zs_doubt = true; }

// The ray has ended. Of a hit that was found by coming close: whether it is between two sides.
int zs_probes = 0;
void certify_trace(Trace trace, real3 o, real3 d, real t1) {
    bool hit = trace.status == zs_hit;
    if (zs_proven_until < (hit ? trace.t - 4.0 * march_epsilon(trace.t) : zs_far)) zs_least = true;
    if (zs_estimates || zs_rounding || zs_enclosed || !hit) return;
    real epsilon = march_epsilon(trace.t);
    field_forget();
    bool outside = true;
    // A bound that compilers cannot see keeps the field in one place.
    for (int i = 0; i < min(int(frame.march.x) + 1, 2); ++i) {
        Answer a = field(o, d, trace.t + (i == 0 ? -epsilon : epsilon));
        ++zs_probes;
        if (i == 0) field_accept();
        zs_enclosed = outside && a.free <= 0.0;
        outside = a.free > 0.0;
    }
    if (trace.t + epsilon > t1) zs_enclosed = false;
}

// That of an earlier frame, where its geometry is kept; -1: none.
int zs_kept_certificate = -1;
void recall_certificate(real told) { zs_kept_certificate = int(told) & 7; }

// As shader::Certificate.
int certificate_of(int status) {
    if (zs_kept_certificate >= 0) return zs_kept_certificate;
    if (status == zs_unresolved) return 6;
    if (!zs_asked) return 1;
    // Cones that went before the rays went by the same scale.
    bool doubt = zs_doubt || zs_estimates || (zs_cones && frame.march.y < 1.0);
    bool hit = status == zs_hit;
    bool rounding = zs_rounding || zs_least || (hit && !zs_enclosed);
    return (doubt ? 4 : (rounding ? 2 : 0)) + (hit ? 0 : 1);
}
