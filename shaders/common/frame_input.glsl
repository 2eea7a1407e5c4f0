#include "common/frame.glsl"

// The frame's numbers from the vertex shader: llvmpipe gathers a uniform lane by lane, wherever it is read,
// which took up to a fifth of a frame.
flat in FrameNumbers frame;
