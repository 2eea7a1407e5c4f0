// Bricks: the box around the bounds is cut into equal ones, as many in each direction. What is known of
// them is a grid for each formula that is known so, one above the other, and perhaps one for the scene.
layout(binding = 5) uniform sampler3D zs_bricks;

// Each brick is known a little beyond its walls (analysis::BrickGrid::margin).
const real zs_brick_margin = 1.0 / 32.0;

struct BrickPlace {
    ivec3 brick;
    real3 inside;         // from the brick's middle, in bricks
    real3 bricks_a_unit;  // how many bricks a unit of space has
    bool known;           // without bounds rays go on where there are no bricks
};

// The brick at a point; beyond the box the nearest one.
BrickPlace brick_place(real3 p) {
    BrickPlace at;
    real side = real(textureSize(zs_bricks, 0).x);
    at.bricks_a_unit = 0.5 * side / frame.bounds_half.xyz;
    real3 place = (p - frame.bounds_centre.xyz) * at.bricks_a_unit + 0.5 * side;
    at.known = zs_has_bounds || all(lessThanEqual(abs(place - 0.5 * side), real3(0.5 * side)));
    place = clamp(place, 0.0, side);
    real3 corner = min(floor(place), side - 1.0);
    at.brick = ivec3(corner);
    at.inside = place - corner - 0.5;
    return at;
}

real2 brick_texel(int grid, BrickPlace at) {
    ivec3 brick = at.brick;
    brick.z += grid * textureSize(zs_bricks, 0).x;
    return texelFetch(zs_bricks, brick, 0).xy;
}
