#include "interval/interval.glsl"

// What a node of the field is in an interval of the ray. As long as its sign tells what is inside, the
// size of the value means nothing.
struct Enclosure {
    real2 value;  // negative inside, positive outside; of a sheet never negative
    real2 rate;   // of its derivative along the ray; zs_all() where that is not known
};

// The derivative along the ray of a leaf whose value `breaks` or not.
real2 enclosed_rate(real2 gx, real2 gy, real2 gz, real3 d, bool breaks) {
    real2 x = d.x < 0.0 ? d.x * gx.yx : d.x * gx;
    real2 y = d.y < 0.0 ? d.y * gy.yx : d.y * gy;
    real2 z = d.z < 0.0 ? d.z * gz.yx : d.z * gz;
    real2 rate = x + y + z;
    real2 room = (max(abs(x.x), abs(x.y)) + max(abs(y.x), abs(y.y)) + max(abs(z.x), abs(z.y))) *
                     real2(1e-6) + 1e-37;
    return breaks || isnan(rate.x + rate.y) ? zs_all() : rate + real2(-1.0, 1.0) * room;
}

// Undefined is outside.
Enclosure solid_enclosure(real2 f, real2 rate, bool breaks) {
    if (isnan(f.x)) return Enclosure(real2(zs_far), zs_all());
    return Enclosure(real2(f.x, breaks ? zs_far : f.y), rate);
}

// Outside wherever f is not 0.
Enclosure sheet_enclosure(real2 f, real2 rate) {
    if (isnan(f.x)) return Enclosure(real2(zs_far), zs_all());
    return Enclosure(real2(max(max(f.x, -f.y), 0.0), max(-f.x, f.y)), rate);
}

// From the answer at the near end: so far there is no root.
Enclosure answer_enclosure(Answer a, real2 t) {
    real way = (t.y - t.x) * 1.000001;
    return Enclosure(real2(a.free - way, a.free + way), zs_all());
}

// Of the operands that may change sides here; `apart` if two of those do not add up to one.
real2 enclosed_pair(real2 a, real2 b, bool apart) { return apart ? zs_all() : interval_hull(a, b); }

Enclosure enclosure_union(Enclosure a, Enclosure b, bool apart) {
    real2 rate = a.value.x > 0.0   ? b.rate
                 : b.value.x > 0.0 ? a.rate
                                   : enclosed_pair(a.rate, b.rate, apart);
    return Enclosure(min(a.value, b.value), rate);
}

Enclosure enclosure_intersection(Enclosure a, Enclosure b, bool apart) {
    real2 rate = a.value.y <= 0.0   ? b.rate
                 : b.value.y <= 0.0 ? a.rate
                                    : enclosed_pair(a.rate, b.rate, apart);
    return Enclosure(max(a.value, b.value), rate);
}

Enclosure enclosure_complement(Enclosure a) { return Enclosure(-a.value.yx, -a.rate.yx); }
