// The Mandelbulb by angles, with the usual estimate r log r / (2 r'). Before this stand
//   const int iterations; const float power
const int max_steps = 256;
int evaluations = 0;

float estimate(vec3 p) {
    ++evaluations;
    vec3 z = p;
    float r = length(z), slope = 1.0;
    for (int i = 0; i < iterations; ++i) {
        float theta = power * acos(z.z / r);
        float phi = power * atan(z.y, z.x);
        slope = power * pow(r, power - 1.0) * slope + 1.0;
        z = pow(r, power) * vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)) + p;
        r = length(z);
        if (r > 4.0) break;
    }
    return 0.5 * r * log(r) / slope;
}

float surface(vec3 p) { return estimate(p); }

float near_enough(float t) { return frame.march.z * pixel_footprint(t); }
