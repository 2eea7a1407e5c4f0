// SPDX-License-Identifier: MIT
// Undo and redo as a history of whole documents.
#pragma once

#include <cstdint>
#include <deque>

#include "scene/document.h"

namespace studio {

/// What the user is doing while the document changes. Changes of one gesture are one step of the
/// history: a gesture that is held (a mouse button) lasts until its id changes, any other one (a
/// burst of typing, the wheel) also ends with a pause.
struct Gesture {
    std::uint64_t id = 0;  ///< 0: every change is a step of its own
    bool held = false;

    friend bool operator==(const Gesture&, const Gesture&) = default;
};

/// The values that a document had, and which of them is present. The oldest are forgotten.
class History {
public:
    static constexpr std::size_t most_steps = 1000;
    static constexpr double pause_seconds = 1.0;

    explicit History(scene::Document initial);

    /// Makes `value` the present one; does nothing if it is that already. What could be redone is
    /// forgotten. `seconds` is a clock that never goes back.
    void record(const scene::Document& value, Gesture gesture, double seconds);

    const scene::Document& present() const { return values_[present_]; }
    bool can_undo() const { return present_ > 0; }
    bool can_redo() const { return present_ + 1 < values_.size(); }
    /// Steps back or forth, as far as that is possible; answers the present value.
    const scene::Document& undo();
    const scene::Document& redo();

private:
    std::deque<scene::Document> values_;
    std::size_t present_ = 0;
    Gesture gesture_;
    double changed_ = 0;
};

}  // namespace studio
