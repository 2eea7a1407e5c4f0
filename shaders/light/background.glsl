// What is seen where there is nothing.
real3 background(real3 d) {
    real height = dot(d, frame.up.xyz) / max(frame.eye.w, 1e-6);
    return mix(frame.background_bottom.rgb, frame.background_top.rgb,
               clamp(0.5 + 0.5 * height, 0.0, 1.0));
}
