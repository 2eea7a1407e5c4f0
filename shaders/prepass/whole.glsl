// Cuts nothing off. For testing.
real2 cone_part(real3 o, real3 axis, real spread) { return real2(0.0, zs_far); }
