// SPDX-License-Identifier: MIT
// What the pixels of a finished picture say about how well it was traced.
#pragma once

#include <cstddef>

#include "image/image.h"

namespace studio {

/// Steps of the primary rays, and how they ended. The counts add up to the number of pixels.
struct PictureStatistics {
    double mean_steps = 0;
    int most_steps = 0;
    std::size_t hit = 0;
    std::size_t missed = 0;
    std::size_t unresolved = 0;  ///< the ray ran out of steps

    friend bool operator==(const PictureStatistics&, const PictureStatistics&) = default;
};

/// The pixels of a normal output with certificates whose ray took a step that is not proven.
std::size_t guessed(const image::Image<float, 4>& normal);

/// Counts the pixels of a geometry output (depth, steps, status, object).
PictureStatistics statistics(const image::Image<float, 4>& geometry);

}  // namespace studio
