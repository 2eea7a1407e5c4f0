#include "output/triangle.glsl"

void main() { cover_target(); }
