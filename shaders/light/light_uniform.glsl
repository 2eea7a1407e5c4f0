// Any number of lights and materials.
real3 light_direction(int i) { return frame_block.light_direction[i].xyz; }
real3 light_colour(int i) { return frame_block.light_colour[i].rgb; }

// Which material an object has; the frame repeats them to as many as it holds.
int material_index(int object) {
    if (zs_objects == 1) return 0;
    return zs_objects <= 16 ? object : object % int(frame.ground.w);
}
real4 object_material(int object) { return frame_block.material[material_index(object)]; }
real object_shininess(int object) { return frame_block.material_shininess[material_index(object)].x; }
