// SPDX-License-Identifier: MIT
#include "studio/accuracy_check.h"

#include <algorithm>
#include <utility>

namespace studio {
namespace {

constexpr double enough_for_one = 0.3, enough_for_all = 4;
constexpr std::size_t most_measured = 48;

/// What else than a Tracing the time of a frame depends on.
scene::Settings light_of(scene::Settings settings) {
    const scene::Settings initial;
    apply(tracing_of(initial), settings);
    settings.ambient_occlusion = initial.ambient_occlusion;
    settings.show_steps = initial.show_steps;
    settings.show_certificate = initial.show_certificate;
    settings.exposure = initial.exposure;
    return settings;
}

std::size_t index_of(const Tracing& tracing, const std::vector<MeasuredSetting>& measured) {
    const auto found = std::ranges::find(measured, tracing, &MeasuredSetting::tracing);
    return static_cast<std::size_t>(found - measured.begin());
}

std::string sentence(const base::Diagnostics& problems) {
    return problems.empty() ? std::string() : problems.front().message;
}

}  // namespace

std::optional<double> MeasuredSetting::frame_seconds() const {
    if (seconds.empty()) return std::nullopt;
    std::vector<double> sorted = seconds;
    std::ranges::sort(sorted);
    return sorted[sorted.size() / 2];
}

const Judged* Accuracy::judged() const {
    return of_this_view && present ? measured[*present].judged.get() : nullptr;
}

AccuracyCheck::AccuracyCheck(Accuracy& accuracy, ReferenceThread::Trace trace,
                             std::function<void()> wake)
    : accuracy_(accuracy), thread_(std::move(trace), std::move(wake)) {}

void AccuracyCheck::look(const PresentView& view, double now) {
    view_ = view;
    ReferenceKey key =
        reference_key(view.document, view.camera, view.width, view.height, accuracy_.divisor);
    if (key != key_) {
        key_ = std::move(key);
        changed_ = now;
    }
    if (thread_.busy() && asked_ != key_) {
        thread_.cancel();
        asked_.reset();
        if (!accuracy_.keep_checking) accuracy_.problem = "given up: the view has changed";
    }
    take_reference();
    accuracy_.of_this_view = accuracy_.reference && accuracy_.key == key_;
    if (!accuracy_.of_this_view) stop_measuring();
    forget_times_of_other_light();
    obey();
    if (starts_by_itself() && now - changed_ >= rest_seconds) start_tracing();
    judge_present();
    if (accuracy_.judged()) accuracy_.last_judged = accuracy_.measured[*accuracy_.present].judged;
    update_phase();
}

void AccuracyCheck::take_reference() {
    auto traced = thread_.take();
    if (!traced) return;
    if (!traced->reference) {
        accuracy_.problem = traced->formula ? sentence(traced->problems)
                                            : "the formula has errors; correct it, and check again";
        return;
    }
    stop_measuring();
    formula_ = std::move(traced->formula);
    accuracy_.key = std::move(traced->key);
    accuracy_.reference = std::move(traced->reference);
    accuracy_.reference_seconds = traced->seconds;
    accuracy_.measured.clear();
    accuracy_.last_judged.reset();
    declined_.reset();
}

void AccuracyCheck::obey() {
    switch (std::exchange(accuracy_.wish, Accuracy::Wish::none)) {
        case Accuracy::Wish::none:
            return;
        case Accuracy::Wish::check:
            if (!view_.playing) start_tracing();
            return;
        case Accuracy::Wish::cancel:
            accuracy_.keep_checking = false;
            thread_.cancel();
            asked_.reset();
            if (schedule_) declined_ = tracing_of(view_.document.settings);
            stop_measuring();
            return;
        case Accuracy::Wish::measure:
            if (!accuracy_.of_this_view || thread_.busy()) return;
            measure(neighbours(tracing_of(view_.document.settings)), enough_for_all,
                    Accuracy::Phase::measuring);
            return;
    }
}

void AccuracyCheck::start_tracing() {
    stop_measuring();
    accuracy_.problem.clear();
    asked_ = key_;
    thread_.start(key_);
}

bool AccuracyCheck::starts_by_itself() const {
    return accuracy_.keep_checking && view_.watched && !view_.playing && !thread_.busy() &&
           asked_ != key_ && accuracy_.key != key_;
}

double AccuracyCheck::wait(double now) const {
    if (!starts_by_itself()) return std::numeric_limits<double>::infinity();
    return std::max(0.0, changed_ + rest_seconds - now);
}

void AccuracyCheck::forget_times_of_other_light() {
    scene::Settings light = light_of(view_.document.settings);
    if (light == light_ && view_.document.lights == lights_) return;
    light_ = std::move(light);
    lights_ = view_.document.lights;
    stop_measuring();
    for (MeasuredSetting& setting : accuracy_.measured) setting.seconds.clear();
}

/// The present setting is tried as soon as it is another one, unless all are being measured.
void AccuracyCheck::judge_present() {
    const Tracing tracing = tracing_of(view_.document.settings);
    const auto find = [&] {
        const std::size_t index = index_of(tracing, accuracy_.measured);
        accuracy_.present.reset();
        if (index < accuracy_.measured.size()) accuracy_.present = index;
    };
    find();
    if (!accuracy_.of_this_view || !view_.watched || thread_.busy()) return;
    if (declined_ == tracing || measuring_ == Accuracy::Phase::measuring) return;
    if (accuracy_.present) {
        const MeasuredSetting& present = accuracy_.measured[*accuracy_.present];
        const bool known = present.failed || (present.judged && !present.seconds.empty());
        if (known && !schedule_) return;
        if (schedule_ && scheduled_.front() == *accuracy_.present) return;
    }
    measure({tracing}, enough_for_one, Accuracy::Phase::judging);
    find();
}

void AccuracyCheck::measure(std::vector<Tracing> settings, double enough_seconds,
                            Accuracy::Phase phase) {
    stop_measuring();
    std::vector<MeasuredSetting>& measured = accuracy_.measured;
    const auto is_asked = [&](const MeasuredSetting& known) {
        return std::ranges::find(settings, known.tracing) != settings.end();
    };
    while (measured.size() + settings.size() > most_measured) {
        const auto oldest = std::ranges::find_if_not(measured, is_asked);
        if (oldest == measured.end()) break;
        measured.erase(oldest);
    }
    for (Tracing& tracing : settings) {
        const std::size_t index = index_of(tracing, measured);
        if (index == measured.size()) measured.push_back({.tracing = std::move(tracing)});
        measured[index].seconds.clear();
        measured[index].failed = false;
        scheduled_.push_back(index);
    }
    schedule_.emplace(scheduled_.size(), enough_seconds);
    measuring_ = phase;
}

void AccuracyCheck::stop_measuring() {
    schedule_.reset();
    scheduled_.clear();
    measuring_ = Accuracy::Phase::idle;
    trial_is_out_ = false;
}

std::optional<TrialRequest> AccuracyCheck::next_trial() {
    if (!schedule_ || trial_is_out_) return std::nullopt;
    const auto turn = schedule_->next();
    if (!turn) return std::nullopt;
    TrialRequest trial{.id = ++trial_,
                       .formula = formula_,
                       .document = view_.document,
                       .reference = accuracy_.reference,
                       .judged = !turn->counts,
                       .expected_seconds = turn->expected_seconds};
    trial.document.camera = key_.scene.camera;
    trial.document.settings.show_steps = false;
    trial.document.settings.show_certificate = false;
    apply(accuracy_.measured[scheduled_[turn->setting]].tracing, trial.document.settings);
    trial_is_out_ = true;
    return trial;
}

void AccuracyCheck::take(const TrialAnswer& answer) {
    if (!trial_is_out_ || answer.id != trial_) return;
    trial_is_out_ = false;
    if (answer.given_up) return;
    const auto turn = schedule_->next();
    MeasuredSetting& setting = accuracy_.measured[scheduled_[turn->setting]];
    if (answer.problems.empty()) {
        if (answer.judged) setting.judged = answer.judged;
        if (turn->counts) setting.seconds.push_back(answer.seconds);
        schedule_->done(answer.seconds);
    } else {
        setting.failed = true;
        accuracy_.problem = describe(setting.tracing) + ": " + sentence(answer.problems);
        schedule_->drop();
    }
    if (!schedule_->next()) stop_measuring();
    update_phase();
}

void AccuracyCheck::update_phase() {
    accuracy_.phase = thread_.busy() ? Accuracy::Phase::tracing : measuring_;
    accuracy_.progress = thread_.busy() ? thread_.progress()
                         : schedule_    ? schedule_->progress()
                                        : 0;
}

}  // namespace studio
