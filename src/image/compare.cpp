// SPDX-License-Identifier: MIT
// How far two pictures differ.
#include "image/compare.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace image {

Difference compare(const Picture& expected, const Picture& actual, int tolerance) {
    assert(expected.width == actual.width && expected.height == actual.height);
    constexpr int amplification = 8;
    Difference result;
    result.picture = Picture(expected.width, expected.height);
    double sum = 0;
    for (std::size_t i = 0; i < expected.values.size(); i += Picture::channels) {
        int largest = 0;
        for (std::size_t k = i; k < i + Picture::channels; ++k) {
            const int apart = std::abs(int{expected.values[k]} - int{actual.values[k]});
            largest = std::max(largest, apart);
            result.picture.values[k] =
                static_cast<std::uint8_t>(std::min(255, amplification * apart));
        }
        result.largest = std::max(result.largest, largest);
        if (largest > tolerance) ++result.changed;
        sum += largest;
    }
    const std::size_t pixels = expected.values.size() / Picture::channels;
    result.mean = pixels == 0 ? 0 : sum / static_cast<double>(pixels);
    return result;
}

}  // namespace image
