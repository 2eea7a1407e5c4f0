// SPDX-License-Identifier: MIT
#include "studio/log_axis.h"

#include <algorithm>
#include <cmath>

namespace studio {
namespace {

constexpr int steps[] = {1, 2, 5};
constexpr std::size_t most_ticks = 7;

/// The number with this index among ... 0.5, 1, 2, 5, 10 ...; 1 has the index 0.
double round_number(int index) {
    const int decade = index >= 0 ? index / 3 : -((2 - index) / 3);
    const int step = steps[index - 3 * decade];
    return decade >= 0 ? step * std::pow(10.0, decade) : step / std::pow(10.0, -decade);
}

/// The index of the largest round number that is at most this value.
int index_below(double value) {
    int index = 3 * static_cast<int>(std::floor(std::log10(value)));
    while (round_number(index) > value) --index;
    while (round_number(index + 1) <= value) ++index;
    return index;
}

}  // namespace

double LogAxis::place(double value) const {
    const double start = zero ? zero_share : 0;
    if (zero && value <= 0) return 0;
    const double part = std::log(std::max(value, low) / low) / std::log(high / low);
    return start + (1 - start) * std::clamp(part, 0.0, 1.0);
}

std::vector<double> LogAxis::ticks() const {
    std::vector<double> all, powers;
    for (int index = index_below(low); round_number(index) <= high; ++index) {
        all.push_back(round_number(index));
        if (index % 3 == 0) powers.push_back(all.back());
    }
    return all.size() <= most_ticks || powers.empty() ? all : powers;
}

LogAxis log_axis(std::span<const double> values, bool zero) {
    LogAxis axis{.zero = zero};
    double least = INFINITY, most = 0;
    for (const double value : values) {
        if (!(value > 0) || !std::isfinite(value)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    if (most == 0) return axis;
    const int low = index_below(least);
    int high = index_below(most);
    if (round_number(high) < most || high == low) ++high;
    axis.low = round_number(low);
    axis.high = round_number(high);
    return axis;
}

}  // namespace studio
