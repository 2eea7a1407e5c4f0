// The lights and the material, from the vertex shader as the frame's numbers are: as many as most scenes have.
flat in LightNumbers zs_lights;

real3 light_direction(int i) { return i == 0 ? zs_lights.direction_0.xyz : zs_lights.direction_1.xyz; }
real3 light_colour(int i) { return i == 0 ? zs_lights.colour_0.rgb : zs_lights.colour_1.rgb; }
real4 object_material(int object) { return zs_lights.material; }
real object_shininess(int object) { return zs_lights.direction_0.w; }
