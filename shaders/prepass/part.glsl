#include "prepass/tile.glsl"

// What the pre-pass has found out about this pixel's tile: the part of the rays, evaluations of the field.
layout(binding = 1) uniform sampler2D tile_parts;

real2 picture_pixel() { return floor(gl_FragCoord.xy) + frame.picture.zw; }

vec4 found_of_tile() {
    real2 tile = floor(picture_pixel() / zs_tile_side) - first_tile();
    return texelFetch(tile_parts, ivec2(tile), 0);
}

// Cuts off what of the part [t0, t1] of the primary ray holds no surface; nothing may be left.
void tile_part(inout real t0, inout real t1) {
    vec4 found = found_of_tile();
    t0 = max(t0, found.x);
    t1 = min(t1, found.y);
}

// The evaluations that a pixel answers for besides its own: the first pixel of a tile for the tile's.
int tile_evaluations() {
    bool first = mod(picture_pixel(), zs_tile_side) == real2(0.0);
    return first ? int(found_of_tile().z) : 0;
}
