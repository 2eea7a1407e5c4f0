#include "common/frame.glsl"

// The frame's numbers as uniforms: in double precision they are too many for inputs.
#define frame frame_block.numbers
