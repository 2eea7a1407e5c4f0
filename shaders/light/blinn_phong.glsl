// Which material an object has; the frame repeats them to as many as it holds.
int material_index(int object) {
    if (zs_objects == 1) return 0;
    return zs_objects <= 16 ? object : object % int(frame.ground.w);
}

// Light from all directional lights by Blinn and Phong, and from the hemispheres above and below.
real3 shade(int object, real3 p, real3 n, real3 d, real footprint) {
    int index = material_index(object);
    real4 material = frame_block.material[index];
    material.rgb = surface_colour(object, p, material.rgb);
    real exponent = frame_block.material_shininess[index].x;
    real3 light = mix(frame.ground.rgb, frame.sky.rgb, 0.5 + 0.5 * n.y) * material.rgb;
    int count = int(frame.sky.w);
    if (count == 0) return light;
    int i = 0;
    // Asked at the end, so that no turn is made in which nothing is left to do.
    do {
        real3 l = frame_block.light_direction[i].xyz;
        real facing = dot(n, l);
        if (facing > 0.0) {
            real3 halfway = normalize(l - d);
            real highlight = material.a * pow(float(max(dot(n, halfway), 0.0)), float(exponent));
            real seen = visibility(p, n, l, footprint);
            light += frame_block.light_colour[i].rgb * seen * (material.rgb * facing + highlight);
        }
    } while (++i < count);
    return light;
}
