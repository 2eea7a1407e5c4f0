// A fixed amount of work that no change of ours touches: what it takes tells how fast the machine is
// at the moment. About as much as a usual frame of 640x480 pixels, whatever the size, so that being
// interrupted costs it as much. Must never change, or runs can no longer be compared.
#version 450 core
layout(std140, binding = 0) uniform Frame {
    vec4 eye;
    vec4 right, up, forward;
    vec4 picture;
} frame;
layout(location = 0) out vec4 picture_out;

void main() {
    vec3 p = vec3((gl_FragCoord.xy + frame.picture.zw) / frame.picture.xy, 0.5);
    vec3 sum = vec3(0.0);
    // A bound that compilers cannot see, so that nothing is unrolled.
    int turns = int(clamp(7372800.0 / (frame.picture.x * frame.picture.y), 1.0, 1e6));
    for (int i = 0; i < turns; ++i) {
        vec3 q = p * p - p.yzx * 0.7 + vec3(0.1, 0.3, -0.2);
        sum += sqrt(dot(q, q) + 1.0) * q.zxy;
        p = q / (1.0 + abs(sum));
    }
    picture_out = vec4(0.5 + 0.5 * p, 1.0);
}
