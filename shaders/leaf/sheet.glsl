#include "leaf/formula.glsl"

// A sheet f = 0. The side on which the ray has been counts as outside, so a negative answer says
// that the ray has just crossed. `side` is the sign of f where the ray was before (0 for unknown),
// `now` gets the sign of f here; the sheet is the wall of the solid turn * f <= 0.
real sheet_turn(real f, real side, out real now) {
    now = f < 0.0 ? -1.0 : (f > 0.0 ? 1.0 : 0.0);
    return side != 0.0 ? side : (now != 0.0 ? now : 1.0);
}

// The answer of the sheet from that of the solid.
Answer answer_sheet(Answer a, real turn) {
    a.sheet = true;
    a.turned = turn < 0.0;
    // Exactly on the surface is not yet across; behind it a way that is rounded to 0 is none.
    if (a.free == 0.0) a.free = a.value < 0.0 ? -1e-30 : 1e-30;
    return a;
}

Answer sheet_answer(real f, real3 g, real3 d, real3 bounds, real side, out real now, int object) {
    real turn = sheet_turn(f, side, now);
    return answer_sheet(formula_answer(turn * f, turn * g, d, bounds, object), turn);
}
