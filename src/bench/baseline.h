// SPDX-License-Identifier: MIT
// What changed between two runs.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "bench/report.h"
#include "bench/statistics.h"

namespace bench {

enum class Speed { same, faster, slower };
enum class Accuracy { same, better, worse, unknown };

/// One configuration that both runs have.
struct Change {
    std::string preset, tracer;
    Move move;
    double ratio = 1;   ///< new over old time, each over the yardstick's beside it
    Interval interval;  ///< where that ratio lies, with a confidence of 99.8 %
    Speed speed = Speed::same;
    std::size_t wrong_before = 0, wrong_now = 0;
    Accuracy accuracy = Accuracy::unknown;  ///< unless both runs counted errors at one size
};

/// Times are compared in units of the yardstick, so that a machine that is slow in one of the runs
/// makes no difference. A verdict is given only where the quartiles of both runs do not overlap and
/// the whole interval is more than 8 % off 1: the margin is for what differs between runs as a
/// whole, such as where a program lies in memory, and no spread within a run can show. Wrong pixels
/// differ if by more than twice the square root of the larger number. Error: other sizes.
base::Result<std::vector<Change>> changes(const Report& before, const Report& now);

/// Of one configuration; for `changes`.
Speed speed(const Interval& interval);
Accuracy accuracy(std::size_t wrong_before, std::size_t wrong_now);

/// True if something is slower or more wrong.
bool has_regression(const std::vector<Change>& changes);

/// What changed, a line each, and how much did not.
std::string changes_text(const std::vector<Change>& changes);

}  // namespace bench
