// What a field says at a point about the ray from there. Negative is inside.
struct Answer {
    real free;      // along the ray no root is nearer: how far the ray may go
    real distance;  // first-order estimate of the distance to the surface; heuristic
    real value;     // f itself, for telling roots from poles
    real rate;      // its derivative along the ray
    bool sheet;     // whether the leaf is a sheet
    bool turned;    // whether f grows towards the inside: in a complement, behind a sheet
    int object;     // the leaf that gave this answer; -1 where there is no surface of it
};

// How many leaves were undefined in the latest evaluation of the field.
int zs_undefined = 0;
// Whether the latest evaluation used a step without a proof.
bool zs_guess = false;
// Of the latest evaluation, how much of the estimates can be relied on (field::Iteration::evenness).
real zs_evenness = 1.0;
// Whether the estimated distance must count what is beside the ray, too.
bool zs_aside = false;
// How far along the ray the nearest wall of a cell is.
real zs_wall = zs_far;

// The way along the ray is one thing, which operand the surface belongs to another: that is told by the
// estimated distance, since the way may be long right behind a surface.
Answer answer_union(Answer a, Answer b) {
    real free = min(a.free, b.free);
    if (b.distance < a.distance) a = b;
    a.free = free;
    return a;
}

// Only a positive operand vouches that the maximum stays positive: the larger answer.
Answer answer_intersection(Answer a, Answer b) {
    real free = max(a.free, b.free);
    if (b.distance > a.distance) a = b;
    a.free = free;
    return a;
}

// A sheet inside of a solid: the solid's wall is no surface.
Answer answer_clip(Answer sheet, Answer solid) {
    solid.object = -1;
    return answer_intersection(sheet, solid);
}

Answer answer_complement(Answer a) {
    return Answer(-a.free, -a.distance, -a.value, -a.rate, a.sheet, !a.turned, a.object);
}

// The point of the latest evaluation.
real3 zs_point = real3(0.0);

// How far to go where nothing is known, such as outside a domain; heuristic.
real blind_step();

// Outside, and undefined: nothing is known about the way ahead.
Answer answer_undefined(int object) {
    ++zs_undefined;
    zs_guess = true;
    return Answer(blind_step(), zs_far, zs_far, 0.0, false, false, object);
}
