// SPDX-License-Identifier: MIT
#include "studio/measuring_schedule.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace studio {

MeasuringSchedule::MeasuringSchedule(std::size_t settings, double enough_seconds)
    : enough_seconds_(enough_seconds), settings_(settings), expected_seconds_(settings, 0) {
    std::iota(settings_.begin(), settings_.end(), std::size_t{0});
    begin_round();
}

std::optional<MeasuringSchedule::Turn> MeasuringSchedule::next() const {
    if (finished_) return std::nullopt;
    const std::size_t setting = turns_.back();
    return Turn{setting, round_ > 0, expected_seconds_[setting]};
}

void MeasuringSchedule::done(double seconds) {
    assert(!finished_);
    double& expected = expected_seconds_[turns_.back()];
    expected = expected > 0 ? std::min(expected, seconds) : seconds;
    if (round_ > 0) measured_seconds_ += seconds;
    end_turn();
}

void MeasuringSchedule::drop() {
    assert(!finished_);
    std::erase(settings_, turns_.back());
    end_turn();
}

double MeasuringSchedule::progress() const {
    if (finished_) return 1;
    const double each = std::accumulate(expected_seconds_.begin(), expected_seconds_.end(), 0.0);
    double rounds = most_rounds;
    if (each > 0) rounds = std::clamp<double>(enough_seconds_ / each, least_rounds, most_rounds);
    const double begun = 1 - static_cast<double>(turns_.size()) /
                                 static_cast<double>(std::max<std::size_t>(settings_.size(), 1));
    return std::clamp((round_ + begun) / (1 + rounds), 0.0, 0.99);
}

void MeasuringSchedule::begin_round() {
    turns_ = settings_;
    std::ranges::reverse(turns_);
    if (turns_.empty()) {
        finished_ = true;
        return;
    }
    const auto first =
        static_cast<std::ptrdiff_t>(static_cast<std::size_t>(round_) % turns_.size());
    std::rotate(turns_.begin(), turns_.end() - first, turns_.end());
}

void MeasuringSchedule::end_turn() {
    turns_.pop_back();
    if (!turns_.empty()) return;
    const bool enough =
        round_ >= most_rounds || (round_ >= least_rounds && measured_seconds_ >= enough_seconds_);
    if (enough) {
        finished_ = true;
        return;
    }
    ++round_;
    begin_round();
}

}  // namespace studio
