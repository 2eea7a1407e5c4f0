// SPDX-License-Identifier: MIT
// Keeps the accuracy panel's numbers up to date: decides what is traced, drawn and measured next.
// Knows neither OpenGL nor the user interface.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "studio/accuracy.h"
#include "studio/measuring_schedule.h"
#include "studio/reference_thread.h"

namespace studio {

/// What the window shows.
struct PresentView {
    scene::Document document;
    scene::Camera camera;
    int width = 0, height = 0;
    bool watched = false;  ///< the accuracy panel is open
    bool playing = false;  ///< t runs
};

/// A reference is kept as long as no other one is asked for; it counts whenever the view is the one
/// that it shows. Of the settings that are tried on it, the present one comes first, and by itself.
class AccuracyCheck {
public:
    /// The view must not have changed for so long before it is checked without a command.
    static constexpr double rest_seconds = 0.6;

    /// Everything that it finds out goes into `accuracy`, which must outlive it.
    AccuracyCheck(Accuracy& accuracy, ReferenceThread::Trace trace, std::function<void()> wake);

    /// To be called whenever something may have changed: takes the user's wish and the traced
    /// reference, and gives up what has become useless. `now` is a clock that never goes back.
    void look(const PresentView& view, double now);
    /// The trial that should be drawn now, if there is one; its answer is waited for.
    std::optional<TrialRequest> next_trial();
    void take(const TrialAnswer& answer);

    /// Seconds until `look` has something to do by itself; infinity for never.
    double wait(double now) const;

private:
    void obey();
    void take_reference();
    void measure(std::vector<Tracing> settings, double enough_seconds, Accuracy::Phase phase);
    void stop_measuring();
    void start_tracing();
    void forget_times_of_other_light();
    void judge_present();
    bool starts_by_itself() const;
    void update_phase();

    Accuracy& accuracy_;
    ReferenceThread thread_;
    std::shared_ptr<const compile::Formula> formula_;  ///< of the reference

    PresentView view_;
    ReferenceKey key_;                   ///< of the view
    double changed_ = 0;                 ///< when the key has changed
    std::optional<ReferenceKey> asked_;  ///< what was traced last, or is being traced
    scene::Settings light_;              ///< what else than a Tracing a frame's time depends on
    std::vector<scene::Light> lights_;
    std::optional<Tracing> declined_;  ///< the user has given up judging it

    std::optional<MeasuringSchedule> schedule_;
    std::vector<std::size_t> scheduled_;  ///< indices into accuracy_.measured
    Accuracy::Phase measuring_ = Accuracy::Phase::idle;
    std::uint64_t trial_ = 0;  ///< the newest one's id
    bool trial_is_out_ = false;
};

}  // namespace studio
