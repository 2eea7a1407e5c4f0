#include "output/surface.glsl"

// One pixel: the primary ray, then whatever is written of it.
void main() {
    real3 o = frame.eye.xyz;
    real3 d = pixel_direction();
    real3 n;
    Trace hit = visible_surface(o, d, n);
    write_pixel(hit, o, d, n);
}
