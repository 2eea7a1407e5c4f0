// SPDX-License-Identifier: MIT
// References of a few pixels, each written down.
#pragma once

#include <limits>
#include <vector>

#include "oracle/metrics.h"
#include "oracle/reference.h"

namespace hand_made {

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();
/// A footprint of a hundredth of the depth: half of it is 0.5 %.
inline constexpr double pixel_width = 0.01;

inline oracle::Pixel hit(double depth, glm::dvec3 normal = {0, 0, 1}) {
    return {.verdict = oracle::Verdict::hit,
            .object = 0,
            .near = depth,
            .far = depth,
            .normal = normal};
}

inline oracle::Pixel miss() {
    return {.verdict = oracle::Verdict::miss, .near = infinity, .far = infinity};
}

inline oracle::Pixel undecided(double near, double far) {
    return {.verdict = oracle::Verdict::undecided, .near = near, .far = far};
}

inline oracle::Pixel fragile(oracle::Pixel pixel) {
    pixel.fragile = true;
    return pixel;
}

/// One row.
inline oracle::Reference row(std::vector<oracle::Pixel> pixels) {
    const int width = static_cast<int>(pixels.size());
    return {.width = width, .height = 1, .pixel_width = pixel_width, .pixels = std::move(pixels)};
}

inline oracle::Shot shot(const std::vector<float>& depths) {
    oracle::Shot shot;
    shot.depth = image::Grey(static_cast<int>(depths.size()), 1);
    shot.depth.values = depths;
    return shot;
}

}  // namespace hand_made
