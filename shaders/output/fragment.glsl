// One pixel: the primary ray, then whatever is written of it.
void main() {
    real3 o = frame.eye.xyz;
    real3 d = pixel_direction();
    Trace hit = Trace(zs_miss, 0.0, -1, false, false, 0);
    real t0, t1;
    if (region_part(o, d, t0, t1)) {
        tile_part(t0, t1);
        if (t0 < t1) hit = trace(o, d, t0, t1);
    }
    real3 n = real3(0.0);
    if (hit.status == zs_hit) {
        real3 p = o + hit.t * d;
        if (!hit.cap) {
            n = surface_normal(hit.object, hit.turned, p, d, pixel_footprint(hit.t));
        } else if (hit.t > 0.0) {
            n = region_normal(p);
        } else {
            n = -d;
        }
    } else if (hit.status == zs_unresolved) {
        n = -d;
    }
    write_pixel(hit, o, d, n);
}
