// The numbers of one frame that every pixel may read.
struct FrameNumbers {
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
    real4 passes;             // the first to run, pixels of what is kept per pixel along x and y
    real4 origin;             // of these coordinates, in the world; which part of the scene is looked at
};

// Two lights and a material.
struct LightNumbers {
    real4 direction_0, direction_1; // unit; of the first, w is the exponent of the highlight
    real4 colour_0, colour_1;
    real4 material; // rgb, strength of the highlight
};

// All of a frame; laid out as render::Frame.
layout(std140, binding = 0) uniform Frame {
    FrameNumbers numbers;
    real4 light_direction[8];
    real4 light_colour[8];
    real4 material[16];           // rgb, strength of the highlight
    real4 material_shininess[16]; // exponent of the highlight
} frame_block;
