// Sphere tracing (Hart 1996) to the first point that is near enough.
const int is_miss = 0, is_hit = 1, is_unresolved = 2;

void main() {
    vec3 o = frame.eye.xyz;
    vec3 d = pixel_direction();
    float t0, t1, t = 0.0;
    int status = is_miss, steps = 0;
    if (region_part(o, d, t0, t1)) {
        status = is_unresolved;
        t = t0;
        for (steps = 0; steps < max_steps; ++steps) {
            float h = estimate(o + t * d);
            if (h < near_enough(t)) {
                status = is_hit;
                break;
            }
            t += h;
            if (t > t1) {
                status = is_miss;
                break;
            }
        }
    }
    int primary = evaluations;
    vec3 n = vec3(0.0);
    vec3 p = o + t * d;
    if (status != is_miss) {
        n = normal_by_central_differences(p, 0.5 * pixel_footprint(t));
        if (dot(n, d) > 0.0) n = -n;
    }
#ifdef PICTURE
    vec3 light = status == is_miss ? background(d) : shade(0, p, n, d, pixel_footprint(t));
    picture_out = vec4(display(light), 1.0);
#endif
#ifdef GEOMETRY
    float depth = status == is_miss ? uintBitsToFloat(0x7f800000u) : t;
    geometry_out = vec4(depth, float(steps), float(status), status == is_miss ? -1.0 : 0.0);
    normal_out = vec4(n, float(primary));
#endif
}
