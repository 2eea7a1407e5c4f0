// A tile is a square of pixels of the full picture, and one fragment of the pre-pass.
const float zs_tile_side = 8.0;

// The first tile that the part of the picture which is drawn has pixels of.
real2 first_tile() { return floor(frame.picture.zw / zs_tile_side); }
