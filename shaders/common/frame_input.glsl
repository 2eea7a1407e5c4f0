#include "common/frame.glsl"

// The frame's numbers from the vertex shader. A GPU reads them as fast as uniforms, llvmpipe much faster:
// it gathers each uniform lane by lane, wherever it is read, which was a quarter of a frame.
flat in FrameNumbers frame;
