// SPDX-License-Identifier: MIT
// How wrong the present view is: what the accuracy panel shows, and what the user wants of it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "studio/reference_key.h"
#include "studio/tracing.h"
#include "studio/trial.h"

namespace studio {

/// A setting that has been tried on the view that the reference shows.
struct MeasuredSetting {
    Tracing tracing;
    std::shared_ptr<const Judged> judged{};  ///< none: not yet, or it cannot be drawn
    std::vector<double> seconds{};           ///< of the frames that count
    bool failed = false;                     ///< it cannot be drawn

    /// The median; none before the first frame that counts.
    std::optional<double> frame_seconds() const;
};

struct Accuracy {
    /// By the user.
    int divisor = 4;             ///< one of check_divisors
    bool keep_checking = false;  ///< trace again whenever the view has come to rest
    bool overlay = true;
    enum class Wish { none, check, cancel, measure };
    Wish wish = Wish::none;

    /// What is going on. Judging is measuring of the present setting alone.
    enum class Phase { idle, tracing, judging, measuring };
    Phase phase = Phase::idle;
    double progress = 0;
    std::string problem;

    /// What is known.
    std::optional<ReferenceKey> key;  ///< of the reference
    std::shared_ptr<const oracle::Reference> reference;
    double reference_seconds = 0;
    bool of_this_view = false;  ///< the reference shows what the window shows
    std::vector<MeasuredSetting> measured;
    std::optional<std::size_t> present;  ///< which of them the present setting is

    /// The last one that was known, to be shown until the next one is; none after a new reference.
    std::shared_ptr<const Judged> last_judged;

    /// The present setting's judgement, if it is known for the view in the window.
    const Judged* judged() const;
};

}  // namespace studio
