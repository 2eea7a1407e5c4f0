// A quaternion Julia set of z^2 + c by the estimate |z| log|z| / (2 |z'|). Before this stand
//   const int iterations; const float slice; const vec4 c
const int max_steps = 256;
int evaluations = 0;

float estimate(vec3 p) {
    ++evaluations;
    vec4 z = vec4(p, slice);
    float square = dot(z, z), slope = 1.0;
    for (int i = 0; i < iterations; ++i) {
        slope *= 4.0 * square;
        z = vec4(z.x * z.x - dot(z.yzw, z.yzw), 2.0 * z.x * z.yzw) + c;
        square = dot(z, z);
        if (square > 16.0) break;
    }
    return 0.25 * sqrt(square / slope) * log(square);
}

float surface(vec3 p) { return estimate(p); }

float near_enough(float t) { return frame.march.z * pixel_footprint(t); }
