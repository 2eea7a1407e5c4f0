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
    bool edge;            // whether only the gradient made the distance small
};

real touch_least(real t) { return zs_relative_step * max(t, 1e-3 * frame.origin.w); }

Touch touch_at(real t, Answer a) {
    real step = max(max(a.free, 0.5 * a.distance), 4.0 * touch_least(t));
    return Touch(t, a, step, a.distance, abs(a.value), 0, 0, false, false);
}

// Where a domain ends the gradient may be infinite, and the estimated distance vanishes though f is not
// zero. Further inside the gradient is smaller while |f| is about the same; at a root of order n, |f| falls
// by r^n where the gradient falls by r^(n-1); at a root on the very edge |f| grows as the gradient falls.
// Heuristic.
bool touch_is_edge(Answer a, Answer further) {
    real v = abs(a.value), w = abs(further.value);
    return w > 0.7 * v && w * a.distance < 0.7 * v * further.distance &&
           w * w * a.distance < 0.8 * v * v * further.distance;
}

// Further off a pole |f| is clearly smaller and the distance larger; both are larger further off a root.
bool touch_is_pole(Answer a, Answer further) {
    return abs(further.value) < 0.7 * abs(a.value) && further.distance > 1.4 * a.distance;
}

// So near that rounding may be all that is seen.
bool touch_is_tiny(Touch touch) { return touch.first_distance <= 64.0 * touch_least(touch.t); }

// Takes the answer one step ahead. True if that ends the search.
bool touch_add(inout Touch touch, Answer a) {
    real gain = touch.answer.distance - a.distance;
    bool falls = abs(a.value) < abs(touch.answer.value);
    if (!(gain > 0.0)) {
        // Out of the domain: back to its edge, and then a look at what is inside.
        if (zs_has_edges && a.distance >= zs_far && touch.step > 0.0) {
            real least = 4.0 * touch_least(touch.t);
            touch.step = touch.step > 2.0 * least ? 0.25 * touch.step : -2.0 * least;
            return false;
        }
        touch.edge = zs_has_edges && touch_is_edge(touch.answer, a);
        if (touch.edge || touch.step < 0.0) return true;
    }
    // Near a pole the distance shrinks while |f| grows. Where the distance is tiny that may be noise, and
    // only further off it is seen clearly.
    if (touch.gains + touch.failures == 0 && (gain > 0.0) != falls) {
        real least = touch_least(touch.t);
        bool clear = touch.step >= 256.0 * least && touch_is_pole(touch.answer, a);
        if (touch_is_tiny(touch) && !clear && touch.step < 4096.0 * least) {
            touch.step *= 4.0;
            return false;
        }
        touch.pole = clear || !touch_is_tiny(touch);
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

// Whether the search has ended on a surface.
bool touch_is_surface(Touch touch) {
    if (touch.edge || touch.pole) return false;
    if (touch_is_tiny(touch)) return true;
    bool edge = touch.answer.distance < 0.1 * touch.first_distance &&
                abs(touch.answer.value) > 0.5 * touch.first_value;
    return !edge;
}
