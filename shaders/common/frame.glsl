// The numbers of one frame; laid out as render::Frame.
layout(std140, binding = 0) uniform Frame {
    real4 eye;                // xyz, tan(fov / 2)
    real4 right, up, forward; // the camera's axes; the width of a pixel at the distance 1, 1 / Lipschitz scale,
                              // a stride where nothing is known
    real4 picture;            // width, height of the full picture; x, y of this part
    real4 bounds_centre;      // xyz, distance at which rays end
    real4 bounds_half;        // xyz, height of the ground
    real4 march;              // steps, Lipschitz scale, epsilon, penumbra
    real4 sky;                // rgb, number of lights
    real4 ground;             // rgb, number of materials
    real4 background_top;     // rgb, exposure
    real4 background_bottom;  // rgb
    real4 light_direction[8];
    real4 light_colour[8];
    real4 material[16];           // rgb, strength of the highlight
    real4 material_shininess[16]; // exponent of the highlight
    real4 passes;                 // the first to run, pixels of what is kept per pixel along x and y
    real4 origin;                 // of these coordinates, in the world; which part of the scene is looked at
} frame;

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
