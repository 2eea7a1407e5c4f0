// The answer of an escape-time set. Where the iteration never escaped is inside, and nothing is
// known about how deep: the step out is heuristic, `distance` continues the estimate near the wall.
Answer iteration_answer(real distance, bool inside, int object) {
    if (isnan(distance)) distance = 0.0;
    if (!inside) {
        real s = max(distance, 0.0);
        return Answer(s / frame.march.y, s, s, 0.0, false, false, object);
    }
    zs_guess = true;
    real depth = min(distance, -1e-30);
    return Answer(-0.125 * blind_step(), depth, depth, 0.0, false, false, object);
}
