// Nothing is known about tiles.
void tile_part(inout real t0, inout real t1) {}
