// SPDX-License-Identifier: MIT
#include "oracle/marked_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace oracle {
namespace {

constexpr double miss_grey = 24;
constexpr double far_grey = 64;
constexpr double near_grey = 224;

/// The depths of a reference as greys, between the nearest and the farthest of them.
class DepthShade {
public:
    explicit DepthShade(const Reference& reference) {
        for (const Pixel& pixel : reference.pixels) {
            if (!is_shown(pixel)) continue;
            nearest_ = std::min(nearest_, pixel.depth());
            farthest_ = std::max(farthest_, pixel.depth());
        }
    }

    std::uint8_t operator()(const Pixel& pixel) const {
        if (!is_shown(pixel)) return static_cast<std::uint8_t>(miss_grey);
        const double range = farthest_ - nearest_;
        const double part = range > 0 ? (pixel.depth() - nearest_) / range : 0;
        return static_cast<std::uint8_t>(std::lround(near_grey + part * (far_grey - near_grey)));
    }

private:
    static bool is_shown(const Pixel& pixel) {
        return pixel.verdict == Verdict::hit && std::isfinite(pixel.depth());
    }

    double nearest_ = std::numeric_limits<double>::infinity();
    double farthest_ = 0;
};

}  // namespace

std::optional<Mark> mark_of(Judgement judgement) {
    switch (judgement) {
        case Judgement::right:
            return std::nullopt;
        case Judgement::missed:
            return Mark{230, 30, 30};
        case Judgement::phantom:
            return Mark{40, 110, 255};
        case Judgement::moved:
            return Mark{255, 200, 0};
        case Judgement::excused:
            return Mark{150, 100, 180};
    }
    return std::nullopt;
}

image::Picture marked_picture(const Reference& reference, const Metrics& metrics) {
    assert(metrics.judgements.size() == reference.pixels.size());
    const DepthShade shade(reference);
    image::Picture picture(reference.width, reference.height);
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        const std::uint8_t grey = shade(reference.pixels[i]);
        const Mark colour = mark_of(metrics.judgements[i]).value_or(Mark{grey, grey, grey});
        std::copy(colour.begin(), colour.end(), &picture.values[3 * i]);
    }
    return picture;
}

}  // namespace oracle
