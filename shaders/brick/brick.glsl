#include "brick/grid.glsl"

// What is known of a formula brick by brick:
//   x = 1 / L with L a Lipschitz constant in the brick; negative where no step is certified
//   y = M, a bound of the second derivative along any ray, 1e30 or more for none; or -k: no root is in
//       the brick nor in the k - 1 bricks around it in any direction
struct Brick {
    real3 bounds;  // as certified_step takes them
    bool empty;    // no root is on the way
    real way;      // how far along the ray this holds
};

Brick brick_at(int grid, real3 p, real3 d) {
    BrickPlace at = brick_place(p);
    real2 known = brick_texel(grid, at);
    if (!at.known) known = real2(-1e-30, 1e30);
    bool empty = known.y < 0.0;
    real reach = (empty ? -known.y - 0.5 : 0.5) + zs_brick_margin;
    real3 rate = d * at.bricks_a_unit;
    real3 ahead = (reach - sign(rate) * at.inside) / max(abs(rate), real3(1e-20));
    real way = at.known ? min(ahead.x, min(ahead.y, ahead.z)) * frame.up.w : zs_far;
    return Brick(real3(abs(known.x), known.y < 1e30 ? known.y : -1.0, known.x < 0.0 ? 1.0 : 0.0), empty,
                 way);
}

// The answer of a formula that is known brick by brick.
Answer answer_in_brick(Answer a, Brick brick) {
    real way = brick.empty ? brick.way : min(abs(a.free), brick.way);
    a.free = a.free < 0.0 ? -way : way;
    return a;
}
