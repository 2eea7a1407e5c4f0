// SPDX-License-Identifier: MIT
// How long analyses may take.
#pragma once

#include <atomic>
#include <functional>
#include <utility>

namespace analysis {

/// Asked by analyses between two pieces of work. When it is over, what is not refined yet keeps the
/// answer of the coarser part that it belongs to, which is as sure but not as close; the least that
/// there must be to draw with is found in any case. What is found then depends on the machine and
/// on the moment. Made to be asked by several threads.
class Budget {
public:
    /// Once `is_over` has said yes, it is not asked again.
    explicit Budget(std::function<bool()> is_over) : ask_(std::move(is_over)) {}

    /// Is over so many seconds from now on.
    static Budget of_seconds(double seconds);

    /// Asked only where something would be left out.
    bool is_over() const {
        if (!over_ && ask_()) over_ = true;
        return over_;
    }
    /// Whether something was left out.
    bool was_over() const { return over_; }

private:
    std::function<bool()> ask_;
    mutable std::atomic<bool> over_ = false;
};

/// What a slider's move is given: a frame.
inline constexpr double frame_seconds = 0.015;

/// Null is without end.
inline bool is_over(const Budget* budget) { return budget && budget->is_over(); }

}  // namespace analysis
