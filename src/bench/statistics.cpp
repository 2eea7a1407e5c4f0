// SPDX-License-Identifier: MIT
#include "bench/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace bench {
namespace {

constexpr int resamplings = 2000;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double median_of_resampling(std::span<const double> values, std::mt19937& random) {
    std::vector<double> drawn(values.size());
    for (double& value : drawn) value = values[random() % values.size()];
    return quantile(drawn, 0.5);
}

}  // namespace

double quantile(std::span<const double> values, double part) {
    if (values.empty()) return nothing;
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    const double place = part * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

Quartiles quartiles(std::span<const double> values) {
    return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

double geometric_mean(std::span<const double> values) {
    if (values.empty()) return nothing;
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / static_cast<double>(values.size()));
}

Quartiles paired_ratio(std::span<const double> a, std::span<const double> b) {
    assert(a.size() == b.size());
    std::vector<double> ratios;
    for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
    return quartiles(ratios);
}

Interval ratio_of_medians(std::span<const double> a, std::span<const double> b, double confidence,
                          std::uint32_t seed) {
    if (a.empty() || b.empty()) return {nothing, nothing};
    std::mt19937 random(seed);
    std::vector<double> ratios;
    for (int i = 0; i < resamplings; ++i) {
        const double below = median_of_resampling(a, random);
        ratios.push_back(median_of_resampling(b, random) / below);
    }
    const double tail = (1 - confidence) / 2;
    return {quantile(ratios, tail), quantile(ratios, 1 - tail)};
}

}  // namespace bench
