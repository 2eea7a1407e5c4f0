// Within bounds a sixty-fourth of the region.
real blind_step() { return frame.forward.w; }
