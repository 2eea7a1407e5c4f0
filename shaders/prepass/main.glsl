#include "prepass/tile.glsl"

// One tile: the part of its rays outside of which none of them meets a surface. The rays lie in the cone
// around the axis: their points at the distance t are closer than spread * t to the axis' point there.
void main() {
    real2 middle = zs_tile_side * (floor(gl_FragCoord.xy) + first_tile() + 0.5);
    real3 axis = picture_direction(middle);
    real spread = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
        real2 aside = zs_tile_side * (real2(corner & 1, corner >> 1) - 0.5);
        spread = max(spread, distance(axis, picture_direction(middle + aside)));
    }
    write_tile(cone_part(frame.eye.xyz, axis, spread + zs_relative_step));
}
