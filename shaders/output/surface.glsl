// What a pixel's primary ray meets, and the normal there.
Trace visible_surface(real3 o, real3 d, out real3 n) {
    Trace hit = Trace(zs_miss, 0.0, -1, false, false, false, 0);
    real t0, t1;
    if (region_part(o, d, t0, t1)) {
        certify_start();
        tile_part(t0, t1);
        if (t0 < t1) hit = trace(o, d, t0, t1);
        certify_trace(hit, o, d, t1);
    }
    n = real3(0.0);
    if (hit.status == zs_hit) {
        real3 p = o + hit.t * d;
        if (!hit.cap) {
            n = surface_normal(hit, p, d);
        } else if (hit.t > 0.0) {
            n = region_normal(p);
        } else {
            n = -d;
        }
    } else if (hit.status == zs_unresolved) {
        n = -d;
    }
    return hit;
}
