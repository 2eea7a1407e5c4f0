// A grid of lines on the ground, one world unit apart, every fifth stronger, fading out far away.
// Lines are a pixel wide, and fade where they would be closer than that.
real grid_line(real2 q, real2 width) {
    real2 away = abs(fract(q - 0.5) - 0.5) / width;
    real2 strength = clamp(1.5 - away, 0.0, 1.0) * clamp(1.0 / (width * 6.0) - 0.5, 0.0, 1.0);
    return max(strength.x, strength.y);
}

real3 behind(real3 o, real3 d, real nearer) {
    real3 far = background(d);
    real t = (frame.bounds_half.w - o.y) / d.y;
    if (!(t > 0.0) || t > frame.bounds_centre.w) return far;
    real3 p = o + t * d;
    real2 q = p.xz + frame.origin.xz;
    real2 width = real2(pixel_footprint(t)) / max(abs(d.y), 0.05);
    real line = max(0.45 * grid_line(q, width), 0.8 * grid_line(q / 5.0, width / 5.0));
    real fade = exp(float(-t / (12.0 * length(frame.bounds_half.xyz))));
    return mix(far, real3(0.75), 0.5 * line * fade);
}
