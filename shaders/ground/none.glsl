// No ground: the background as it is.
real3 behind(real3 o, real3 d, real nearer) { return background(d); }
