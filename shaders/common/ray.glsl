// The unit direction of the ray through a place of the full picture, in pixels from its left and top.
real3 picture_direction(real2 place) {
    real x = 2.0 * place.x / frame.picture.x - 1.0;
    real y = 1.0 - 2.0 * place.y / frame.picture.y;
    real k = frame.eye.w;
    return normalize(frame.forward.xyz + (k * x * frame.picture.x / frame.picture.y) * frame.right.xyz +
                     (k * y) * frame.up.xyz);
}

// Through the centre of this fragment's pixel. Counted in whole pixels of the full picture, so that a
// part is drawn exactly as the whole would be.
real3 pixel_direction() {
    return picture_direction(floor(gl_FragCoord.xy) + frame.picture.zw + 0.5);
}

// The width of a pixel at a distance along the ray.
real pixel_footprint(real t) { return t * frame.right.w; }
