#include "brick/grid.glsl"

// How far around a point nothing of the scene is, by the bricks (a lower bound); 0 where something may be.
real empty_around(real3 p) {
    BrickPlace at = brick_place(p);
    real rings = -brick_texel(zs_scene_grid, at).y;
    real3 aside = (rings - 0.5 - abs(at.inside)) / at.bricks_a_unit;
    real inside = rings > 0.0 ? min(aside.x, min(aside.y, aside.z)) : 0.0;
    // From beyond the box everything in it is at least as far as from the nearest point of the box.
    real3 beyond = abs(p - frame.bounds_centre.xyz) - frame.bounds_half.xyz;
    return max(inside, max(beyond.x, max(beyond.y, beyond.z)));
}

// The cone is left out as far as it lies in balls around points of its axis that hold nothing, from both
// ends (as cone marching goes by a distance: Seven 2012).
real2 cone_part(real3 o, real3 axis, real spread) {
    real middle = distance(frame.bounds_centre.xyz, o);
    real reach = 1.01 * length(frame.bounds_half.xyz);
    real near = max(middle - reach, 0.0), far = middle + reach;
    real least = 0.05 * min(frame.bounds_half.x, min(frame.bounds_half.y, frame.bounds_half.z)) /
                 real(textureSize(zs_bricks, 0).x);
    int most = min(int(frame.march.x) + 64, 96);
    for (int i = 0; i < most; ++i) {
        real step = (empty_around(o + near * axis) - spread * near) / (1.0 + spread);
        if (step < least) break;
        near += step;
        if (near > far) return real2(zs_far, 0.0);
    }
    for (int i = 0; i < most; ++i) {
        real step = empty_around(o + far * axis) - spread * far;
        if (step < least || far < near) break;
        far -= step;
    }
    return real2(near, far);
}
