// SPDX-License-Identifier: MIT
#include "render/passes.h"

#include <cstring>
#include <type_traits>

namespace render {
namespace {

bool same(const Frame& a, const Frame& b) {
    static_assert(std::is_trivially_copyable_v<Frame>);
    return std::memcmp(&a, &b, sizeof a) == 0;
}

Frame without_what_the_image_reads(Frame frame) {
    frame.background_top.w = 0;  // the exposure
    return frame;
}

Frame without_what_light_reads(Frame frame) {
    frame.sky = frame.ground = frame.background_top = frame.background_bottom = glm::dvec4(0);
    frame.light_direction = frame.light_colour = {};
    frame.material = frame.material_shininess = {};
    frame.march.w = 0;  // the shadows' softness
    return frame;
}

}  // namespace

std::optional<Pass> first_changed(const Frame& before, const Frame& now) {
    if (same(before, now)) return std::nullopt;
    const Frame a = without_what_the_image_reads(before), b = without_what_the_image_reads(now);
    if (same(a, b)) return Pass::image;
    const bool same_geometry = same(without_what_light_reads(a), without_what_light_reads(b));
    return same_geometry ? Pass::light : Pass::geometry;
}

}  // namespace render
