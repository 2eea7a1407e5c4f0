// Polynomial smooth minimum of two distances over the width k; 1-Lipschitz if both are.
Answer answer_smooth_union(Answer a, Answer b, real k) {
    real overlap = max(k - abs(a.distance - b.distance), 0.0) / k;
    real blend = min(a.distance, b.distance) - overlap * overlap * k * 0.25;
    if (b.distance < a.distance) a = b;
    return Answer(blend / frame.march.y, blend, blend, 0.0, false, a.turned, a.object);
}
