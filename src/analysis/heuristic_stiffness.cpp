// SPDX-License-Identifier: MIT
#include "analysis/heuristic_stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace analysis {
namespace {

constexpr unsigned sample_count = 256;

double ratio_or_zero(double numerator, double bound) {
    if (bound == numeric::infinity) return 0;
    return bound > 0 ? numerator / bound : numeric::infinity;
}

}  // namespace

double heuristic_steps(const eval::Tape& f, const Region& region,
                       std::span<const double> parameters, double lipschitz,
                       double second_derivative) {
    if (lipschitz == numeric::infinity && second_derivative == numeric::infinity) {
        return numeric::infinity;
    }
    std::vector<double> registers, steps;
    eval::load_parameters<double>(f, parameters, registers);
    for (unsigned i = 0; i < sample_count; ++i) {
        const glm::dvec3 p = spread_point(region, i);
        double value = 0;
        eval::evaluate_loaded<double>(f, std::array{p.x, p.y, p.z}, std::span(&value, 1),
                                      registers);
        if (std::isnan(value)) continue;
        steps.push_back(std::max(ratio_or_zero(std::abs(value), lipschitz),
                                 std::sqrt(ratio_or_zero(2 * std::abs(value), second_derivative))));
    }
    if (steps.empty()) return numeric::infinity;
    const auto median = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::ranges::nth_element(steps, median);
    return *median > 0 ? diameter(region) / *median : numeric::infinity;
}

}  // namespace analysis
