// A leaf whose value is a signed distance bound: good in every direction.
Answer distance_answer(real distance, int object) {
    if (isnan(distance)) return answer_undefined(object);
    return Answer(distance * frame.up.w, distance, distance, 0.0, false, false, object);
}
