// SPDX-License-Identifier: MIT
// How far two pictures differ.
#pragma once

#include "image/image.h"

namespace image {

/// Differences of two pictures of one size, over the largest channel difference of each pixel, in
/// steps of 8-bit sRGB.
struct Difference {
    int largest = 0;
    double mean = 0;
    std::size_t changed = 0;  ///< pixels that differ by more than the tolerance
    Picture picture;          ///< the difference of each pixel, amplified eight times
};
Difference compare(const Picture& expected, const Picture& actual, int tolerance);

}  // namespace image
