// The colour of an object's surface: its own at the point, else its material's. What is negative or
// undefined counts as 0.
real3 surface_colour(int object, real3 p, real3 material) {
    real3 colour;
    if (!object_colour(object, p, colour)) return material;
    return real3(colour.r > 0.0 ? colour.r : 0.0, colour.g > 0.0 ? colour.g : 0.0, colour.b > 0.0 ? colour.b : 0.0);
}
