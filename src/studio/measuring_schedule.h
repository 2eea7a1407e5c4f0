// SPDX-License-Identifier: MIT
// The order in which settings are measured against each other.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace studio {

/// Rounds in which every setting has one turn, so that a slow moment of the machine hits all alike;
/// each round begins with another setting. The first round is for judging and for warming up: its
/// times do not count. Knows no clock.
class MeasuringSchedule {
public:
    static constexpr int least_rounds = 3, most_rounds = 15;  ///< that count

    struct Turn {
        std::size_t setting = 0;
        bool counts = false;          ///< its time is a measurement
        double expected_seconds = 0;  ///< 0: not known yet
    };

    /// After `least_rounds` it is enough once so much time has been measured.
    MeasuringSchedule(std::size_t settings, double enough_seconds);

    /// Whose turn it is, the same until `done` or `drop`; none when all is measured.
    std::optional<Turn> next() const;
    /// The present turn took so long.
    void done(double seconds);
    /// The present turn's setting cannot be drawn.
    void drop();

    /// The finished part, estimated.
    double progress() const;

private:
    void begin_round();
    void end_turn();

    double enough_seconds_;
    std::vector<std::size_t> settings_;     ///< that can be drawn
    std::vector<double> expected_seconds_;  ///< by setting: the shortest time so far
    int round_ = 0;
    std::vector<std::size_t> turns_;  ///< of this round, the next one last
    double measured_seconds_ = 0;
    bool finished_ = false;
};

}  // namespace studio
