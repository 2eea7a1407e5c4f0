// Without bounds rays go far beyond the region that is framed, and by larger steps there.
real blind_step() {
    real away = distance(zs_point, frame.bounds_centre.xyz);
    return away > 64.0 * frame.forward.w ? away / 16.0 : frame.forward.w;
}
