// Light from all directional lights by Blinn and Phong, and from the hemispheres above and below.
real3 shade(int object, real3 p, real3 n, real3 d, real footprint) {
    int index = object % max(int(frame.ground.w), 1);
    vec4 material = frame.material[index];
    material.rgb = surface_colour(object, p, material.rgb);
    real exponent = frame.material_shininess[index].x;
    real3 light = mix(frame.ground.rgb, frame.sky.rgb, 0.5 + 0.5 * n.y) * material.rgb;
    for (int i = 0; i < int(frame.sky.w); ++i) {
        real3 l = frame.light_direction[i].xyz;
        real facing = dot(n, l);
        if (facing <= 0.0) continue;
        real3 halfway = normalize(l - d);
        real highlight = material.a * pow(max(dot(n, halfway), 0.0), exponent);
        real seen = visibility(p, n, l, footprint);
        light += frame.light_colour[i].rgb * seen * (material.rgb * facing + highlight);
    }
    return light;
}
