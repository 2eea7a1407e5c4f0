// SPDX-License-Identifier: MIT
#include "oracle/metrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace oracle {
namespace {

base::Status check_size(const Reference& reference, std::string_view what, int width, int height) {
    if (width == reference.width && height == reference.height) return base::Done{};
    return base::error(
        fmt::format("the reference has {}x{} pixels, the {} {}x{}; compare pictures of one size",
                    reference.width, reference.height, what, width, height));
}

base::Status check_sizes(const Reference& reference, const Shot& shot) {
    const base::Status depth = check_size(reference, "depth", shot.depth.width, shot.depth.height);
    if (!depth || shot.normal.values.empty()) return depth;
    return check_size(reference, "normal", shot.normal.width, shot.normal.height);
}

bool is_depth(float value) { return value >= 0; }

Judgement judge(const Pixel& pixel, double pixel_width, float got) {
    if (pixel.verdict == Verdict::undecided || pixel.fragile) return Judgement::excused;
    if (pixel.verdict == Verdict::miss) {
        return is_depth(got) && std::isinf(got) ? Judgement::right : Judgement::phantom;
    }
    if (!is_depth(got) || std::isinf(got)) return Judgement::missed;
    const double apart = std::max({pixel.near - got, got - pixel.far, 0.0});
    return apart > 0.5 * pixel_width * pixel.depth() ? Judgement::moved : Judgement::right;
}

double relative_error(const Pixel& pixel, float got) {
    // A hit at depth 0 is right only with the depth 0.
    return pixel.depth() == 0 ? 0 : std::abs(got - pixel.depth()) / pixel.depth();
}

double angle_between(glm::dvec3 expected, const float* got) {
    const glm::dvec3 normal(got[0], got[1], got[2]);
    if (!(glm::length(normal) > 0)) return 180;
    return std::atan2(glm::length(glm::cross(expected, normal)), glm::dot(expected, normal)) * 180 /
           std::numbers::pi;
}

double percentile(const std::vector<double>& sorted, double part) {
    const auto rank =
        static_cast<std::size_t>(std::ceil(part * static_cast<double>(sorted.size())));
    return sorted[std::max<std::size_t>(rank, 1) - 1];
}

Spread spread_of(std::vector<double> errors) {
    if (errors.empty()) return {};
    std::sort(errors.begin(), errors.end());
    return {percentile(errors, 0.5), percentile(errors, 0.99), errors.back()};
}

void count(Metrics& metrics, const Pixel& pixel, Judgement judgement, float got, bool gave_up) {
    switch (judgement) {
        case Judgement::right:
            break;
        case Judgement::missed:
            ++metrics.missed;
            break;
        case Judgement::phantom:
            ++metrics.phantom;
            break;
        case Judgement::moved:
            ++metrics.moved;
            break;
        case Judgement::excused:
            ++(pixel.verdict == Verdict::undecided ? metrics.undecided : metrics.fragile);
            return;
    }
    ++metrics.compared;
    if (!is_depth(got)) ++metrics.no_depth;
    if (gave_up) ++metrics.gave_up;
}

}  // namespace

base::Result<Metrics> compare(const Reference& reference, const Shot& shot) {
    if (const base::Status sizes = check_sizes(reference, shot); !sizes) return sizes.problems();
    Metrics metrics;
    metrics.judgements.reserve(reference.pixels.size());
    std::vector<double> depth_errors;
    std::vector<double> normal_errors;
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        const Pixel& pixel = reference.pixels[i];
        const float got = shot.depth.values[i];
        const Judgement judgement = judge(pixel, reference.pixel_width, got);
        metrics.judgements.push_back(judgement);
        count(metrics, pixel, judgement, got, i < shot.gave_up.size() && shot.gave_up[i]);
        if (judgement != Judgement::right || pixel.verdict != Verdict::hit) continue;
        depth_errors.push_back(relative_error(pixel, got));
        if (!shot.normal.values.empty() && pixel.normal != glm::dvec3(0)) {
            normal_errors.push_back(angle_between(pixel.normal, &shot.normal.values[3 * i]));
        }
    }
    metrics.depth_error = spread_of(std::move(depth_errors));
    metrics.normal_error = spread_of(std::move(normal_errors));
    return metrics;
}

}  // namespace oracle
