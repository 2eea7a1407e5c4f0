#include "common/frame.glsl"

// For light/light_input.glsl, in the vertex shader.
flat out LightNumbers zs_lights;

void pass_lights() {
    zs_lights.direction_0 = real4(frame_block.light_direction[0].xyz, frame_block.material_shininess[0].x);
    zs_lights.direction_1 = frame_block.light_direction[1];
    zs_lights.colour_0 = frame_block.light_colour[0];
    zs_lights.colour_1 = frame_block.light_colour[1];
    zs_lights.material = frame_block.material[0];
}
