// SPDX-License-Identifier: MIT
#include "studio/history.h"

#include <utility>

namespace studio {

History::History(scene::Document initial) { values_.push_back(std::move(initial)); }

void History::record(const scene::Document& value, Gesture gesture, double seconds) {
    if (value == present()) return;
    const bool same_gesture = gesture.id != 0 && gesture.id == gesture_.id;
    const bool continues =
        same_gesture && (gesture.held || seconds - changed_ < pause_seconds) && !can_redo();
    if (continues) {
        values_[present_] = value;
    } else {
        values_.resize(present_ + 1);
        values_.push_back(value);
        if (values_.size() > most_steps + 1) values_.pop_front();
        present_ = values_.size() - 1;
    }
    gesture_ = gesture;
    changed_ = seconds;
}

const scene::Document& History::undo() {
    if (can_undo()) --present_;
    gesture_ = {};
    return present();
}

const scene::Document& History::redo() {
    if (can_redo()) ++present_;
    gesture_ = {};
    return present();
}

}  // namespace studio
