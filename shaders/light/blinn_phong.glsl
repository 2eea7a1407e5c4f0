// Light from all directional lights by Blinn and Phong, and from the hemispheres above and below.
real3 shade(int object, real3 p, real3 n, real3 d, real footprint) {
    real4 material = object_material(object);
    material.rgb = surface_colour(object, p, material.rgb);
    real exponent = object_shininess(object);
    real3 light = mix(frame.ground.rgb, frame.sky.rgb, 0.5 + 0.5 * n.y) * material.rgb;
    int count = int(frame.sky.w);
    if (count == 0) return light;
    int i = 0;
    // Asked at the end, so that no turn is made in which nothing is left to do.
    do {
        real3 l = light_direction(i);
        real facing = dot(n, l);
        if (facing > 0.0) {
            real3 halfway = normalize(l - d);
            real highlight = material.a * pow(float(max(dot(n, halfway), 0.0)), float(exponent));
            real seen = visibility(p, n, l, footprint);
            light += light_colour(i) * seen * (material.rgb * facing + highlight);
        }
    } while (++i < count);
    return light;
}
