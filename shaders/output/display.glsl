// Linear light to what a display is sent: exposure, then the sRGB transfer function (IEC 61966-2-1).
vec3 display(real3 light) {
    vec3 c = clamp(vec3(light * frame.background_top.w), 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}
