// What tracers differ in: the strides along a ray.

// Before a ray, and before it goes on behind a pole.
void stride_start();
// The answer at the end of a stride.
Answer stride_answer(real3 o, real3 d, real t);
// Whether the stride `way` that led to this answer may have passed a surface; then the ray goes by
// stride_back() from where it began.
bool stride_has_parted(Answer a, real way);
real stride_back();
// How far to go on, where the field allows `free`.
real stride(real free, real epsilon);
// Whether the stride may be longer than that, and is looked at where it leads.
bool stride_is_checked();

// No distance along a ray is told apart from less than this.
real least_step(real t) { return 2.0 * zs_relative_step * max(t, 1e-3 * frame.origin.w); }

// How far the coordinates of a point on the ray are off: a product and a sum are rounded.
real position_error(real t) { return 0.3 * least_step(t); }

// A hit is closer than this; no stride is shorter.
real march_epsilon(real t) { return max(frame.march.z * pixel_footprint(t), least_step(t)); }
