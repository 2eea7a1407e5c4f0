// SPDX-License-Identifier: MIT
// Pixels in memory. Row 0 is the top.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace image {

/// A rectangle of pixels with `Channels` values each, row by row from the top left.
template <class Value, int Channels>
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Value> values;

    static constexpr int channels = Channels;

    Image() = default;
    Image(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * h * Channels) {}

    Value* at(int x, int y) {
        return &values[(static_cast<std::size_t>(y) * width + x) * Channels];
    }
    const Value* at(int x, int y) const {
        return &values[(static_cast<std::size_t>(y) * width + x) * Channels];
    }

    friend bool operator==(const Image&, const Image&) = default;
};

using Picture = Image<std::uint8_t, 3>;  ///< sRGB-encoded
using Grey = Image<float, 1>;
using Vectors = Image<float, 3>;

}  // namespace image
