#include "common/frame.glsl"
#include "output/triangle.glsl"

// For common/frame_input.glsl.
flat out FrameNumbers frame;

void main() {
    cover_target();
    frame = frame_block.numbers;
    pass_field_values();
    pass_lights();
}
