// Brings a point that is closer than a fraction of a pixel to its surface down to float accuracy, by
// secant steps on the estimated distance, which is linear near a simple and near a double root.
struct Touch {
    real t;               // the best point so far
    Answer answer;        // there
    real step;            // how far ahead to look next
    real first_distance;  // at the first point
    real first_value;     // |f| there
    int gains;            // how often the distance has become smaller
    int failures;         // how often it has not
    bool pole;            // whether |f| and the distance went different ways
};

real touch_least(real t) { return zs_relative_step * max(t, 1e-3); }

Touch touch_at(real t, Answer a) {
    real step = max(max(a.free, 0.5 * a.distance), 4.0 * touch_least(t));
    return Touch(t, a, step, a.distance, abs(a.value), 0, 0, false);
}

// Takes the answer one step ahead. True if that ends the search.
bool touch_add(inout Touch touch, Answer a) {
    real gain = touch.answer.distance - a.distance;
    bool falls = abs(a.value) < abs(touch.answer.value);
    // Near a pole the distance shrinks while |f| grows.
    if (touch.gains + touch.failures == 0 && (gain > 0.0) != falls) {
        touch.pole = true;
        return true;
    }
    if (!(gain > 0.0)) {
        // A long step of a grazing ray may have gone too far; a short one ends in the noise of f.
        bool is_short = touch.step < 0.03 * pixel_footprint(touch.t);
        touch.step *= 0.25;
        return is_short || ++touch.failures > 4;
    }
    real ahead = a.distance * touch.step / gain;
    touch.t += touch.step;
    touch.answer = a;
    touch.step = min(ahead, 256.0 * pixel_footprint(touch.t));
    return ++touch.gains >= 16 || ahead <= touch_least(touch.t);
}

// Whether the search has ended on a surface. At the edge of a domain the gradient may be infinite and
// the estimate vanish where f does not.
bool touch_is_surface(Touch touch) {
    if (touch.first_distance <= 64.0 * touch_least(touch.t)) return true;
    bool edge = touch.answer.distance < 0.1 * touch.first_distance &&
                abs(touch.answer.value) > 0.5 * touch.first_value;
    return !touch.pole && !edge;
}
