// Brings a point that is closer than a pixel to its surface down to float accuracy, by secant steps
// on the estimated distance, which is linear near a simple and near a double root.
struct Touch {
    real t;         // the best point so far
    Answer answer;  // there
    real next;      // where to look next
    real farthest;
    int gains;      // how often the distance has become smaller
    bool falling;   // whether |f| became smaller where the distance did not
};

Touch touch_at(real t, Answer a) {
    real least = 4.0 * zs_relative_step * max(t, 1e-3);
    return Touch(t, a, t + max(max(a.free, 0.5 * a.distance), least),
                 t + 4.0 * pixel_footprint(t), 0, false);
}

// Takes the answer at the point asked for. True if that ends the search.
bool touch_add(inout Touch touch, Answer a) {
    real gain = touch.answer.distance - a.distance;
    if (!(gain > 0.0)) {
        touch.falling = abs(a.value) < abs(touch.answer.value);
        return true;
    }
    if (++touch.gains >= 12) return true;
    real ahead = a.distance * (touch.next - touch.t) / gain;
    touch.t = touch.next;
    touch.answer = a;
    touch.next = min(touch.t + ahead, touch.farthest);
    return ahead <= zs_relative_step * max(touch.t, 1e-3) || touch.next <= touch.t;
}

// Whether the search has ended on a surface. Behind a pole the estimate is small as well, but grows
// while |f| falls.
bool touch_is_surface(Touch touch) { return touch.gains > 0 || !touch.falling; }
