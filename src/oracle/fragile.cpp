// SPDX-License-Identifier: MIT
#include "oracle/fragile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace oracle {
namespace {

/// Half a footprint over the shift is 17 footprints a pixel; neighbours that are farther apart than
/// this many are looked at closely.
constexpr double steep = 8;

}  // namespace

bool may_be_fragile(const Reference& reference, int x, int y) {
    const Pixel& centre = reference.at(x, y);
    const int right = std::min(x + 1, reference.width - 1);
    const int bottom = std::min(y + 1, reference.height - 1);
    for (int j = std::max(y - 1, 0); j <= bottom; ++j) {
        for (int i = std::max(x - 1, 0); i <= right; ++i) {
            const Pixel& other = reference.at(i, j);
            if (other.verdict != centre.verdict || other.object != centre.object) return true;
            if (centre.verdict == Verdict::miss) continue;
            const double footprint = reference.pixel_width * centre.depth();
            if (std::abs(other.depth() - centre.depth()) > steep * footprint) return true;
        }
    }
    return false;
}

bool is_fragile(PixelTracer& trace, const Pixel& pixel, double x, double y, const Places& places,
                double pixel_width) {
    constexpr std::array<std::pair<double, double>, 4> shifts{
        {{fragile_shift, 0}, {-fragile_shift, 0}, {0, fragile_shift}, {0, -fragile_shift}}};
    return std::ranges::any_of(shifts, [&](const auto& shift) {
        const Pixel other = trace.estimated(x + shift.first, y + shift.second, places);
        if (other.verdict != pixel.verdict || other.object != pixel.object) return true;
        if (pixel.verdict == Verdict::miss) return false;
        return std::abs(other.depth() - pixel.depth()) > 0.5 * pixel_width * pixel.depth();
    });
}

}  // namespace oracle
